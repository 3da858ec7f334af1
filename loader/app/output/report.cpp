#include "app/output/report.h"

#include <fmt/format.h>

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>

#include <orris/core/limits.h>
#include <orris/core/printable.h>

namespace orris {
namespace {

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
  Printer printer(all(), output_, style_, folder_);
  const std::size_t known = all().size();
  problems_.add(diagnostics);
  for (std::size_t i = known; i < all().size() && prints_; ++i) printer.add(all()[i]);
}

void Report::add(Diagnostic diagnostic) {
  Diagnostics one{std::move(diagnostic)};
  add(one);
}

void Report::error(const std::string& id, const std::string& message, const std::string& hint,
                   const std::string& path) {
  add({.id = id, .at = {.file = path}, .message = message, .hint = hint});
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

void printText(std::string_view text) { std::cout << printableLines(text) << std::flush; }

void printJson(const nlohmann::json& result) { std::cout << jsonText(result); }

void printJson(nlohmann::json result, const Report& report) {
  if (!report.output().json) return;
  result["diagnostics"] = toJson(report.all());
  printJson(result);
}

}  // namespace orris
