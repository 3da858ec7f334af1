#include <orris/glsl/compile/compiler_log.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

#include <orris/core/characters.h>
#include <orris/glsl/syntax/syntax_message.h>
#include <orris/glsl/tokens/text_tokens.h>

namespace orris {
namespace {

class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool literal(std::string_view wanted) {
    if (!text_.starts_with(wanted)) return false;
    text_.remove_prefix(wanted.size());
    return true;
  }

  bool number(int& value) {
    const auto [end, error] = std::from_chars(text_.data(), text_.data() + text_.size(), value);
    if (error != std::errc() || value < 0) return false;
    text_.remove_prefix(static_cast<std::size_t>(end - text_.data()));
    return true;
  }

  void blanks() {
    while (!text_.empty() && (text_.front() == ' ' || text_.front() == '\t'))
      text_.remove_prefix(1);
  }

  std::string_view rest() const { return text_; }

 private:
  std::string_view text_;
};

bool startsWithNoCase(std::string_view text, std::string_view lowerPrefix) {
  return text.size() >= lowerPrefix.size() &&
         std::equal(lowerPrefix.begin(), lowerPrefix.end(), text.begin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

struct SeverityWord {
  std::string_view word;
  Severity severity;
};

constexpr std::array<SeverityWord, 5> kSeverityWords = {{
    {"preprocessor error", Severity::Error},
    {"fatal error", Severity::Error},
    {"error", Severity::Error},
    {"warning", Severity::Warning},
    {"note", Severity::Note},
}};

// Takes "error: ", "warning C7050: " or "error(#143) " off the front.
std::string_view takeSeverity(std::string_view text, Severity& severity) {
  for (const SeverityWord& word : kSeverityWords) {
    if (!startsWithNoCase(text, word.word)) continue;
    std::string_view rest = text.substr(word.word.size());
    if (rest.starts_with(" C") || rest.starts_with("(#")) {
      const std::size_t end = rest.find_first_of(rest.front() == ' ' ? ":" : ")");
      if (end == std::string_view::npos) return text;
      rest.remove_prefix(end);
    }
    if (rest.empty() || (rest.front() != ':' && rest.front() != ')')) continue;
    severity = word.severity;
    return rest.substr(1);
  }
  return text;
}

// Mesa: "0:12(34): error: ..."
bool readMesa(std::string_view line, LogEntry& entry) {
  Scanner s(line);
  int source = 0;
  if (!s.number(source) || !s.literal(":") || !s.number(entry.line) || !s.literal("(") ||
      !s.number(entry.column) || !s.literal("):")) {
    return false;
  }
  s.blanks();
  entry.message = takeSeverity(s.rest(), entry.severity);
  return true;
}

// NVIDIA: "0(12) : error C1503: ..."
bool readNvidia(std::string_view line, LogEntry& entry) {
  Scanner s(line);
  int source = 0;
  if (!s.number(source) || !s.literal("(") || !s.number(entry.line) || !s.literal(")"))
    return false;
  s.blanks();
  if (!s.literal(":")) return false;
  s.blanks();
  entry.message = takeSeverity(s.rest(), entry.severity);
  return true;
}

// glslang, AMD, Intel, Apple: "ERROR: 0:12: ..."
bool readGlslang(std::string_view line, LogEntry& entry) {
  Severity severity = entry.severity;
  const std::string_view rest = takeSeverity(line, severity);
  if (rest.size() == line.size()) return false;
  Scanner s(rest);
  s.blanks();
  int source = 0;
  if (!s.number(source) || !s.literal(":") || !s.number(entry.line) || !s.literal(":"))
    return false;
  s.blanks();
  entry.severity = severity;
  entry.message = takeSeverity(s.rest(), entry.severity);
  return true;
}

bool isSummary(std::string_view text) {
  constexpr std::array<std::string_view, 8> kSummaries = {
      "compilation errors", "compilation terminated",
      "failed to compile",  "successfully compiled",
      "No code generated",  "Vertex info",
      "Fragment info",      "Compute info"};
  const bool rule = text.find_first_not_of("- \t") == std::string_view::npos;
  return rule ||
         std::any_of(kSummaries.begin(), kSummaries.end(), [text](std::string_view summary) {
           return text.find(summary) != std::string_view::npos;
         });
}

std::string_view trim(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::optional<LogEntry> readLine(std::string_view line, Severity fallback) {
  for (auto* read : {readMesa, readNvidia, readGlslang}) {
    LogEntry entry;
    entry.severity = fallback;
    if (read(line, entry)) return entry;
  }
  if (isSummary(line)) return std::nullopt;
  LogEntry entry;
  entry.severity = fallback;
  entry.message = takeSeverity(line, entry.severity);
  return entry;
}

// Mesa lists the candidates of a call as further messages at the same place, indented.
bool continuesLast(const LogEntry& entry, const std::vector<LogEntry>& entries) {
  return entry.line > 0 && !entries.empty() && entries.back().line == entry.line &&
         entries.back().column == entry.column && entry.message.starts_with("   ");
}

// Column of `word` as a whole word in the given line of the compiled text; 0 when it is not there.
int findWord(const MappedText& text, int line, std::string_view word) {
  if (word.empty()) return 0;
  std::size_t start = 0;
  for (int i = 1; i < line; ++i) {
    start = text.text.find('\n', start);
    if (start == std::string::npos) return 0;
    ++start;
  }
  const std::string_view whole(text.text);
  const std::string_view row = whole.substr(start, whole.find('\n', start) - start);
  for (std::size_t at = row.find(word); at != std::string_view::npos; at = row.find(word, at + 1)) {
    const bool opens = at == 0 || !isWordCharacter(word.front()) || !isWordCharacter(row[at - 1]);
    const std::size_t end = at + word.size();
    const bool closes =
        end >= row.size() || !isWordCharacter(word.back()) || !isWordCharacter(row[end]);
    if (opens && closes) return static_cast<int>(at) + 1;
  }
  return 0;
}

// Compilers quote the word they mean: 'x' (glslang, Apple), `x' (Mesa), "x" (NVIDIA).
int columnOfQuotedWord(const MappedText& text, const LogEntry& entry) {
  const std::string& message = entry.message;
  std::size_t at = 0;
  while ((at = message.find_first_of("'`\"", at)) != std::string::npos) {
    const char close = message[at] == '"' ? '"' : '\'';
    const std::size_t end = message.find(close, at + 1);
    if (end == std::string::npos) return 0;
    std::string_view word = std::string_view(message).substr(at + 1, end - at - 1);
    word = word.substr(0, word.find('('));
    const int column = findWord(text, entry.line, word);
    if (column > 0) return column;
    at = end + 1;
  }
  return 0;
}

std::string macroNote(const MappedText& text, int macro) {
  const auto index = static_cast<std::size_t>(macro);
  SourceLocation at;
  if (index < text.macroOrigins.size()) at = locate(text.sites, text.macroOrigins[index]);
  if (at.file.empty()) return fmt::format("expanded from macro '{}'", text.macroNames[index]);
  return fmt::format("expanded from macro '{}', defined at {}:{}", text.macroNames[index], at.file,
                     at.line);
}

// The compiler names the token after the mistake, which may stand lines below or in another file.
bool moveTo(Diagnostic& d, const Token& token, const SourceLocation& at, std::string hint,
            const MappedText& text, const SourceLines& lines) {
  if (at.file.empty()) return false;
  d.at = at;
  d.includedFrom = text.includedFrom(token.origin.line, token.origin.column);
  d.hint = std::move(hint);
  if (lines) d.sourceLine = lines(at.file, at.line);
  return true;
}

bool moveToMistake(Diagnostic& d, const LogEntry& entry, const SyntaxMessage& syntax,
                   const MappedText& text, const SourceLines& lines) {
  if (const auto before = tokenBeforeGap(text, entry.line, entry.message)) {
    const bool said = !syntax.behind.empty();
    const std::string hint =
        said ? "" : fmt::format("something is missing after '{}'", before->text);
    if (moveTo(d, *before, placeAfter(text, *before), hint, text, lines)) {
      if (said) d.message = fmt::format("{} '{}'", syntax.behind, before->text);
      return true;
    }
  }
  const auto open = unclosedParenthesis(text, entry.line, entry.message);
  if (!open || open->origin.line == entry.line) return false;
  return moveTo(d, *open, text.locate(open->origin.line, open->origin.column),
                "no ')' of this line closes it", text, lines);
}

// What a macro's body holds is wrong where the author wrote it, whatever the number of its uses.
void moveIntoMacro(Diagnostic& d, const MappedText& text, int line, int column) {
  const SourceLocation inMacro = text.locateInMacro(line, column);
  const int macro = text.macroIndexAt(line, column);
  if (macro < 0) return;
  if (inMacro.file.empty()) {
    d.notes.insert(d.notes.begin(), macroNote(text, macro));
    return;
  }
  d.notes.insert(d.notes.begin(), fmt::format("in the expansion of macro '{}' at {}:{}",
                                              text.macroNames[static_cast<std::size_t>(macro)],
                                              d.at.file, d.at.line));
  d.includedFrom.clear();
  d.at = inMacro;
}

}  // namespace

std::vector<LogEntry> parseCompilerLog(std::string_view log, Severity fallback) {
  std::vector<LogEntry> entries;
  // Drivers hand over the terminating NUL now and then.
  log = log.substr(0, log.find('\0'));
  while (!log.empty()) {
    const std::size_t end = std::min(log.find('\n'), log.size());
    const bool indented = log.front() == ' ' || log.front() == '\t';
    const std::string_view line = trim(log.substr(0, end));
    log.remove_prefix(std::min(end + 1, log.size()));
    if (line.empty()) continue;
    std::optional<LogEntry> entry = readLine(line, fallback);
    if (!entry) continue;
    // glslang's linker says on indented lines what it compares.
    if (indented && entry->line == 0 && entry->message == line && !entries.empty()) {
      entries.back().notes.emplace_back(line);
      continue;
    }
    // glslang lists extensions, each on a line of its own.
    if (entry->line == 0 && line.starts_with("GL_") && !entries.empty() &&
        entries.back().message.ends_with("extensions include:")) {
      entries.back().notes.emplace_back(line);
      continue;
    }
    const std::string message(trim(entry->message));
    if (continuesLast(*entry, entries)) {
      entries.back().notes.push_back(message);
      continue;
    }
    if (entry->line > 0 && isSummary(message)) continue;
    entry->message = message;
    entries.push_back(std::move(*entry));
  }
  return entries;
}

Diagnostic locateLogEntry(const LogEntry& entry, std::string id, const StageText& stage,
                          const SourceLines& lines) {
  const MappedText& text = stage.text;
  Diagnostic d;
  d.severity = entry.severity;
  d.id = std::move(id);
  d.message = entry.message;
  d.notes = entry.notes;
  const SyntaxMessage syntax = readSyntaxError(text, entry.line, entry.message);
  if (!syntax.text.empty()) d.message = syntax.text;
  const int column = entry.column > 0    ? entry.column
                     : syntax.column > 0 ? syntax.column
                                         : columnOfQuotedWord(text, entry);
  if (moveToMistake(d, entry, syntax, text, lines)) return d;
  if (entry.line > 0) d.at = text.locate(entry.line, column);
  if (d.at.file.empty()) {
    if (!text.sites.empty()) d.at = {text.sites.front().file, 0, 0};
    if (entry.line > 0) d.notes.push_back("the place is in text added by the host");
    return d;
  }
  if (column == 0) d.at.column = 0;
  d.includedFrom = text.includedFrom(entry.line, column);
  if (column > 0) moveIntoMacro(d, text, entry.line, column);
  if (lines) d.sourceLine = lines(d.at.file, d.at.line);
  return d;
}

void mapDriverLog(const std::string& log, Severity fallback, const StageText& stage,
                  const SourceLines& lines, Diagnostics& diagnostics) {
  LogEntry unlocated;
  unlocated.severity = Severity::Note;
  std::set<int> linesInError;
  for (const LogEntry& entry : parseCompilerLog(log, fallback)) {
    if (entry.line > 0) {
      // Compilers go on after an error; what they then find on its line follows from it.
      if (entry.severity == Severity::Error && !linesInError.insert(entry.line).second) continue;
      diagnostics.push_back(locateLogEntry(entry, "driver-compile", stage, lines));
      continue;
    }
    if (!unlocated.message.empty()) unlocated.message += "; ";
    unlocated.message += entry.message;
    unlocated.severity = std::max(unlocated.severity, entry.severity);
  }
  if (!unlocated.message.empty()) {
    diagnostics.push_back(locateLogEntry(unlocated, "driver-log", stage, lines));
  }
}

}  // namespace orris
