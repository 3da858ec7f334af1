#include <orris/core/message_limits.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <orris/core/limits.h>

namespace orris {
namespace {

bool startsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

/// Where `text` may be cut at or before `at`, between two characters.
std::size_t cutAt(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && !startsCharacter(text[at])) --at;
  return at;
}

void cutText(std::string& text) {
  if (text.size() <= limits::kMessageBytes) return;
  text.resize(cutAt(text, limits::kMessageBytes));
  text += " ...";
}

/// The innermost sites and the program file say most.
void cutChain(std::vector<SourceLocation>& chain) {
  if (chain.size() <= limits::kMessageIncludes) return;
  chain[limits::kMessageIncludes - 1] = chain.back();
  chain.resize(limits::kMessageIncludes);
}

void cutTexts(Diagnostic& d) {
  if (d.sourceLine.size() > limits::kQuotedLineBytes)
    d.sourceLine = quotedLine(d.sourceLine, d.at.column);
  cutChain(d.includedFrom);
  if (d.notes.size() > limits::kMessageNotes) d.notes.resize(limits::kMessageNotes);
  for (std::string& note : d.notes) cutText(note);
  cutText(d.message);
  cutText(d.hint);
}

std::size_t bytesOf(const Diagnostic& d) {
  return sizeof d + d.at.file.size() + d.message.size() + d.sourceLine.size() + d.hint.size() +
         d.notes.size() * sizeof(std::string) + d.includedFrom.size() * sizeof(SourceLocation);
}

Diagnostic leftOut(const Diagnostic& first) {
  return {
      .severity = first.severity,
      .id = "messages-left-out",
      .at = first.at,
      .message = fmt::format(
          "there are more messages of the kind {} than are kept: from here on they are left out",
          first.id),
      .hint = "mend what those above it say first"};
}

}  // namespace

std::string quotedLine(std::string_view line, int column) {
  if (line.size() <= limits::kQuotedLineBytes) return std::string(line);
  const auto end = static_cast<std::size_t>(std::max(column, 1)) - 1;
  if (end < limits::kQuotedLineBytes / 2)
    return std::string(line.substr(0, cutAt(line, limits::kQuotedLineBytes)));
  std::size_t begin = std::min(end, line.size()) - limits::kQuotedLineBytes / 2;
  while (begin < line.size() && !startsCharacter(line[begin])) ++begin;
  return "..." + std::string(line.substr(begin, std::min(end, line.size()) - begin));
}

void MessageBudget::count(const Diagnostic& diagnostic) {
  ++kinds_[diagnostic.id];
  bytes_ += bytesOf(diagnostic);
  anyError_ |= diagnostic.severity == Severity::Error;
}

MessageBudget::Verdict MessageBudget::take(Diagnostic& diagnostic) {
  // A few of every kind are kept even when other kinds used up the bytes.
  constexpr std::size_t kAlways = 10;
  cutTexts(diagnostic);
  const bool firstError = diagnostic.severity == Severity::Error && !anyError_;
  std::size_t& ofKind = kinds_[diagnostic.id];
  const bool fits = ofKind < limits::kMessagesOfAKind && bytes_ < limits::kMessageListBytes;
  if (firstError || ofKind < kAlways || fits) {
    count(diagnostic);
    return Verdict::Keep;
  }
  if (ofKind > limits::kMessagesOfAKind) return Verdict::Drop;
  ofKind = limits::kMessagesOfAKind + 1;
  diagnostic = leftOut(diagnostic);
  return Verdict::LastOfItsKind;
}

void boundMessages(Diagnostics& diagnostics) {
  MessageBudget budget;
  std::erase_if(diagnostics,
                [&](Diagnostic& d) { return budget.take(d) == MessageBudget::Verdict::Drop; });
}

}  // namespace orris
