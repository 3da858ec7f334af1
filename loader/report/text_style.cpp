#include <orris/report/text_style.h>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr int kNarrowest = 40, kIndent = 2;
constexpr std::string_view kBold = "\x1b[1m", kRed = "\x1b[1;31m", kYellow = "\x1b[1;33m",
                           kBlue = "\x1b[1;34m", kGreen = "\x1b[32m", kDim = "\x1b[2m",
                           kPlain = "\x1b[0m";

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value != '\0';
}

bool forcesColour() {
  return isSet("CLICOLOR_FORCE") && std::string_view(std::getenv("CLICOLOR_FORCE")) != "0";
}

int widthOf(int descriptor, int otherwise) {
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return otherwise;
  return std::max<int>(size.ws_col, kNarrowest);
}

bool startsCharacter(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }

// Lists of blocks in properties run over thousands of columns: what counts is around the caret.
void clipSourceLine(Diagnostic& diagnostic, int widest) {
  std::string& line = diagnostic.sourceLine;
  if (std::ssize(line) <= widest) return;
  constexpr int kDots = 3;
  const int room = widest - 2 * kDots;
  const int size = static_cast<int>(line.size());
  int begin = std::clamp(diagnostic.at.column - 1 - room * 5 / 8, 0, size - room);
  int end = begin + room;
  while (begin > 0 && !startsCharacter(line[std::size_t(begin)])) --begin;
  while (end < size && !startsCharacter(line[std::size_t(end)])) ++end;
  const bool more = end < size;
  line = (begin > 0 ? "..." : "") + line.substr(std::size_t(begin), std::size_t(end - begin)) +
         (more ? "..." : "");
  if (begin > 0) diagnostic.at.column -= begin - kDots;
}

/// Only what lies in the pack has a path of it.
void openPath(std::string& file, const std::string& folder) {
  if (file.starts_with('/') && !folder.empty() && fs::exists(folder + file)) file = folder + file;
}

void openPaths(Diagnostic& diagnostic, const std::string& folder) {
  openPath(diagnostic.at.file, folder);
  for (SourceLocation& place : diagnostic.includedFrom) openPath(place.file, folder);
  for (RelatedPlace& place : diagnostic.related) openPath(place.at.file, folder);
}

std::string painted(std::string_view colour, std::string_view text) {
  return fmt::format("{}{}{}", colour, text, kPlain);
}

std::string_view colourOf(Severity severity) {
  return severity == Severity::Error     ? kRed
         : severity == Severity::Warning ? kYellow
                                         : kBlue;
}

std::string paintedHead(const std::string& line, Severity severity) {
  const std::string word = fmt::format("{}: ", severityName(severity));
  const std::size_t at = line.find(word);
  const std::size_t id = line.rfind(" [");
  if (at == std::string::npos || id == std::string::npos || id < at) return line;
  const std::size_t message = at + word.size();
  return painted(kBold, line.substr(0, at)) + painted(colourOf(severity), word) +
         painted(kBold, line.substr(message, id - message)) + painted(kDim, line.substr(id));
}

std::string paintedLine(const std::string& line, const Diagnostic& diagnostic) {
  constexpr std::string_view kNote = "  note: ", kHint = "  hint: ", kFrom = "  included from ";
  if (line.starts_with(kNote)) return painted(kBlue, kNote) + line.substr(kNote.size());
  if (line.starts_with(kHint)) return painted(kGreen, kHint) + line.substr(kHint.size());
  if (line.starts_with(kFrom)) return painted(kDim, line);
  const bool caret = line.ends_with('^') && line.find_first_not_of(" \t") == line.size() - 1;
  return caret ? painted(colourOf(diagnostic.severity), line) : line;
}

std::string paint(const std::string& text, const Diagnostic& diagnostic) {
  std::string result;
  for (const std::string& line : splitLines(text)) {
    result += result.empty() ? paintedHead(line, diagnostic.severity)
                             : '\n' + paintedLine(line, diagnostic);
  }
  return result;
}

}  // namespace

bool isShown(Severity severity, const Verbosity& verbosity) {
  const Severity least = verbosity.quiet     ? Severity::Error
                         : verbosity.verbose ? Severity::Note
                                             : Severity::Warning;
  return severity >= least;
}

TextStyle styleOf(int descriptor) {
  TextStyle style;
  const bool terminal = isatty(descriptor) != 0;
  const char* kind = std::getenv("TERM");
  const bool dumb = !kind || std::string_view(kind) == "dumb";
  style.colour = !isSet("NO_COLOR") && (forcesColour() || (terminal && !dumb));
  style.openPaths = terminal;
  if (terminal) style.width = widthOf(descriptor, style.width);
  return style;
}

std::string shadersFolderOf(const std::string& packPath) {
  std::error_code error;
  if (!fs::is_directory(packPath, error)) return "shaders";
  fs::path root = fs::path(packPath);
  if (fs::is_directory(root / "shaders", error)) root /= "shaders";
  const fs::path here = fs::current_path(error);
  const fs::path inside = root.is_absolute() ? root.lexically_relative(here) : fs::path();
  if (!inside.empty() && *inside.begin() != "..") root = inside;
  std::string text = root.lexically_normal().generic_string();
  while (text.size() > 1 && text.ends_with('/')) text.pop_back();
  return text;
}

std::string styledText(Diagnostic diagnostic, const TextStyle& style, const std::string& folder) {
  if (!diagnostic.id.empty()) diagnostic.message += fmt::format(" [{}]", diagnostic.id);
  if (style.openPaths) openPaths(diagnostic, folder);
  const std::string whole = formatDiagnostic(diagnostic);
  clipSourceLine(diagnostic, style.width - kIndent);
  const std::string clipped = formatDiagnostic(diagnostic);
  // The place stays the true one; only the excerpt and its caret are those of the clipped line.
  const std::string text = whole.substr(0, whole.find('\n')) +
                           clipped.substr(std::min(clipped.find('\n'), clipped.size()));
  return style.colour ? paint(text, diagnostic) : text;
}

}  // namespace orris
