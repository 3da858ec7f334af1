#include <orris/report/problem_list.h>

#include <fmt/format.h>

#include <orris/core/message_limits.h>

namespace orris {
namespace {

// The chain of includes is left out: one mistake in a shared file is one problem, however many
// programs include it.
std::string problemKey(const Diagnostic& diagnostic) {
  return fmt::format("{} {}:{}:{} {}", severityName(diagnostic.severity), diagnostic.at.file,
                     diagnostic.at.line, diagnostic.at.column, diagnostic.message);
}

const std::string& entryFileOf(const Diagnostic& diagnostic) {
  return diagnostic.includedFrom.empty() ? diagnostic.at.file : diagnostic.includedFrom.back().file;
}

}  // namespace

void ProblemList::add(Diagnostics& diagnostics) {
  MessageBudget budget;
  for (const Diagnostic& diagnostic : all_) budget.count(diagnostic);
  for (Diagnostic& diagnostic : diagnostics) {
    const std::string key = problemKey(diagnostic);
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
    if (isNew) all_.push_back(std::move(diagnostic));
  }
  diagnostics.clear();
}

void ProblemList::restore(Diagnostics all, std::vector<std::set<std::string>> entryFiles,
                          std::vector<std::optional<std::size_t>> causes) {
  all_ = std::move(all);
  entryFiles_ = std::move(entryFiles);
  causes_ = std::move(causes);
  contexts_.assign(all_.size(), {});
}

void ProblemList::beginAgain() {
  ProblemList kept;
  kept.context_ = std::move(context_);
  std::vector<const std::string*> keys(all_.size());
  for (const auto& [key, index] : seen_) keys[index] = &key;
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const bool stays = keys[i] != nullptr && met_.contains(*keys[i]);
    if (all_[i].severity == Severity::Error || !stays) continue;
    kept.seen_.emplace(*keys[i], kept.all_.size());
    kept.all_.push_back(std::move(all_[i]));
    kept.entryFiles_.push_back(std::move(entryFiles_[i]));
    kept.causes_.emplace_back();
    kept.contexts_.push_back(std::move(contexts_[i]));
  }
  *this = std::move(kept);
}

void ProblemList::noteContexts(std::size_t count) {
  for (std::size_t i = 0; i < all_.size(); ++i) {
    const std::vector<std::string>& contexts = contexts_[i];
    if (all_[i].severity == Severity::Note || contexts.front().empty()) continue;
    // A program that several profiles share is compiled for the first of them only.
    if (contexts.size() < count) all_[i].notes.push_back("first met with " + contexts.front());
  }
}

void ProblemList::error(const std::string& id, const std::string& message,
                        const std::string& hint) {
  Diagnostics one;
  one.push_back({.id = id, .message = message, .hint = hint});
  add(one);
}

}  // namespace orris
