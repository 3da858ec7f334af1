#include "app/report/report.h"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include "core/limits.h"
#include "core/message_limits.h"
#include "core/printable.h"

namespace orris {
namespace {

// The chain of includes is left out: one mistake in a shared file is one problem, however many
// programs include it.
std::string keyOf(const Diagnostic& diagnostic) {
  return fmt::format("{} {}:{}:{} {}", severityName(diagnostic.severity), diagnostic.at.file,
                     diagnostic.at.line, diagnostic.at.column, diagnostic.message);
}

const std::string& entryFileOf(const Diagnostic& diagnostic) {
  return diagnostic.includedFrom.empty() ? diagnostic.at.file : diagnostic.includedFrom.back().file;
}

/// Prints the first of each kind; `all` are those before it.
class Printer {
 public:
  Printer(const Diagnostics& all, const OutputOptions& output, const TextStyle& style,
          const std::string& folder)
      : output_(output), style_(style), folder_(folder) {
    for (const Diagnostic& diagnostic : all) count(diagnostic);
  }

  void add(const Diagnostic& diagnostic) {
    const std::size_t nth = count(diagnostic);
    if (!isShown(diagnostic.severity, output_)) return;
    if (nth <= limits::kPrintedOfAKind || output_.verbose) {
      std::cerr << styledText(diagnostic, style_, folder_) << std::endl;
    } else if (nth == limits::kPrintedOfAKind + 1) {
      std::cerr << fmt::format("more messages of the kind {} follow; --verbose prints them\n",
                               diagnostic.id);
    }
  }

 private:
  std::size_t count(const Diagnostic& diagnostic) {
    return isShown(diagnostic.severity, output_) ? ++printed_[diagnostic.id] : 0;
  }

  const OutputOptions& output_;
  const TextStyle& style_;
  const std::string& folder_;
  std::map<std::string, std::size_t> printed_;
};

}  // namespace

void Report::add(Diagnostics& diagnostics) {
  MessageBudget budget;
  for (const Diagnostic& diagnostic : all_) budget.count(diagnostic);
  Printer printer(all_, output_, style_, folder_);
  for (Diagnostic& diagnostic : diagnostics) {
    const std::string key = keyOf(diagnostic);
    met_.insert(key);
    auto place = seen_.find(key);
    const bool isNew = place == seen_.end();
    if (isNew) {
      if (budget.take(diagnostic) == MessageBudget::Verdict::Drop) continue;
      place = seen_.emplace(key, all_.size()).first;
      entryFiles_.emplace_back();
      causes_.emplace_back();
      contexts_.emplace_back();
    }
    entryFiles_[place->second].insert(entryFileOf(diagnostic));
    std::vector<std::string>& contexts = contexts_[place->second];
    if (contexts.empty() || contexts.back() != context_) contexts.push_back(context_);
    if (!isNew) continue;
    if (mode_ == Mode::Print) printer.add(diagnostic);
    all_.push_back(std::move(diagnostic));
  }
  diagnostics.clear();
}

void Report::restore(Diagnostics all, std::vector<std::set<std::string>> entryFiles,
                     std::vector<std::optional<std::size_t>> causes) {
  all_ = std::move(all);
  entryFiles_ = std::move(entryFiles);
  causes_ = std::move(causes);
  contexts_.assign(all_.size(), {});
}

bool isShown(Severity severity, const OutputOptions& output) {
  const Severity least = output.quiet     ? Severity::Error
                         : output.verbose ? Severity::Note
                                          : Severity::Warning;
  return severity >= least;
}

void Report::beginAgain() {
  std::erase_if(seen_, [&](const auto& entry) {
    return all_[entry.second].severity == Severity::Error || !met_.contains(entry.first);
  });
  met_.clear();
}

void Report::noteContexts(std::size_t count) {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const std::vector<std::string>& contexts = contexts_[i];
    if (all_[i].severity == Severity::Note || contexts.front().empty()) continue;
    // A program that several profiles share is compiled for the first of them only.
    if (contexts.size() < count) all_[i].notes.push_back("first met with " + contexts.front());
  }
}

void Report::error(const std::string& id, const std::string& message, const std::string& hint,
                   const std::string& path) {
  Diagnostics one(1);
  one[0].id = id;
  one[0].message = message;
  one[0].hint = hint;
  one[0].at.file = path;
  add(one);
}

void sayWritten(const OutputOptions& output, const std::vector<std::string>& paths,
                const std::string& what) {
  if (output.json || output.quiet) return;
  std::string list;
  for (const std::string& path : paths) {
    if (!path.empty()) list += (list.empty() ? "" : ", ") + path;
  }
  if (list.empty()) return;
  printText("wrote " + list + (what.empty() ? "" : " (" + what + ")") + '\n');
}

nlohmann::json toJson(const SourceLocation& location) {
  return {{"file", location.file}, {"line", location.line}, {"column", location.column}};
}

nlohmann::json toJson(const Diagnostics& diagnostics) {
  nlohmann::json list = nlohmann::json::array();
  for (const Diagnostic& diagnostic : diagnostics) {
    nlohmann::json entry = toJson(diagnostic.at);
    entry["severity"] = severityName(diagnostic.severity);
    entry["id"] = diagnostic.id;
    entry["message"] = diagnostic.message;
    entry["includedFrom"] = nlohmann::json::array();
    for (const SourceLocation& place : diagnostic.includedFrom) {
      entry["includedFrom"].push_back(toJson(place));
    }
    entry["sourceLine"] = diagnostic.sourceLine;
    entry["related"] = nlohmann::json::array();
    for (const RelatedPlace& place : diagnostic.related) {
      entry["related"].push_back(toJson(place.at));
      entry["related"].back()["message"] = place.message;
    }
    entry["notes"] = diagnostic.notes;
    entry["hint"] = diagnostic.hint;
    if (diagnostic.effect != Effect::Unstated) entry["effect"] = effectName(diagnostic.effect);
    list.push_back(std::move(entry));
  }
  return list;
}

void printText(std::string_view text) { std::cout << printableLines(text) << std::flush; }

std::string jsonText(const nlohmann::json& value) {
  // Packs are untrusted: bytes that are not UTF-8 must not end the program.
  std::string text = value.dump(2, ' ', true, nlohmann::json::error_handler_t::replace);
  // Some runners of CI services look for "##[command]" anywhere in a line.
  for (std::size_t at = 0; (at = text.find("##", at)) != std::string::npos; ++at)
    text.replace(at + 1, 1, "\\u0023");
  return text + '\n';
}

void printJson(const nlohmann::json& result) { std::cout << jsonText(result); }

void printJson(nlohmann::json result, const Report& report) {
  if (!report.output().json) return;
  result["diagnostics"] = toJson(report.all());
  printJson(result);
}

}  // namespace orris
