#include <orris/core/files/text_file.h>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include <orris/core/limits.h>

namespace orris {
namespace {

Diagnostic tooLarge(std::string_view path, int line, std::string message) {
  return {.severity = Severity::Error,
          .id = "text-too-large",
          .at = {.file = std::string(path), .line = line},
          .message = std::move(message),
          .hint = "no published pack comes near this; split the file or leave parts of it out"};
}

bool isProperties(std::string_view path) {
  return path.ends_with(".properties") || path.ends_with(".lang");
}

bool isBlank(char c) { return static_cast<unsigned char>(c) <= ' '; }

/// Counts what the readers of texts keep an entry for.
class Counter {
 public:
  Counter(std::string_view path, bool properties) : path_(path), properties_(properties) {}

  /// The error where a limit is met.
  std::optional<Diagnostic> count(std::string_view text) {
    bool inWord = false, lineHasWord = false, afterReturn = false;
    for (const char c : text) {
      if (!isBlank(c) && !inWord) {
        ++words_;
        fullLines_ += lineHasWord ? 0 : 1;
        lineHasWord = true;
      }
      inWord = !isBlank(c);
      const bool ends = c == '\r' || (c == '\n' && !afterReturn);
      afterReturn = c == '\r';
      if (!ends) continue;
      if (auto problem = entries()) return problem;
      lineHasWord = false;
      if (++line_ > limits::kTextFileLines) return refuse(limits::kTextFileLines, "lines");
    }
    return entries();
  }

 private:
  std::optional<Diagnostic> entries() const {
    if (!properties_) return std::nullopt;
    if (fullLines_ > limits::kPropertyLines)
      return refuse(limits::kPropertyLines, "lines that are not blank");
    if (words_ > limits::kPropertyWords) return refuse(limits::kPropertyWords, "words");
    return std::nullopt;
  }

  Diagnostic refuse(std::size_t most, std::string_view what) const {
    return tooLarge(path_, static_cast<int>(line_),
                    fmt::format("the file has more than {} {}; it is not read", most, what));
  }

  std::string_view path_;
  bool properties_;
  std::size_t line_ = 1, fullLines_ = 0, words_ = 0;
};

std::optional<Diagnostic> problemOf(std::string_view path, std::string_view bytes) {
  if (bytes.size() > limits::kTextFileBytes) {
    const auto kept = bytes.substr(0, limits::kTextFileBytes);
    return tooLarge(path, static_cast<int>(std::count(kept.begin(), kept.end(), '\n')) + 1,
                    fmt::format("the file has {} bytes, more than {}; it is not read", bytes.size(),
                                limits::kTextFileBytes));
  }
  if (isUtf16(bytes)) {
    return Diagnostic{.severity = Severity::Error,
                      .id = "text-utf16",
                      .at = {.file = std::string(path), .line = 1, .column = 1},
                      .message = "this file is UTF-16, which no host reads",
                      .hint = "save it as UTF-8"};
  }
  return Counter(path, isProperties(path)).count(bytes);
}

}  // namespace

bool isUtf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  constexpr std::size_t kLetters = 8;
  if (bytes.size() < 2 * kLetters) return false;
  for (const std::size_t first : {0, 1}) {
    bool all = true;
    for (std::size_t i = 0; i < kLetters; ++i)
      all &= bytes[2 * i + first] == '\0' && bytes[2 * i + 1 - first] != '\0';
    if (all) return true;
  }
  return false;
}

TextFile readTextFile(const FileSource& source, std::string_view path) {
  TextFile file;
  auto bytes = source.read(path);
  if (!bytes) return file;
  if (auto problem = problemOf(path, *bytes)) {
    file.problem = std::move(*problem);
  } else {
    file.ok = true;
    file.bytes = std::move(*bytes);
  }
  return file;
}

std::optional<std::string> readText(const FileSource& source, std::string_view path) {
  TextFile file = readTextFile(source, path);
  return file.ok ? std::optional(std::move(file.bytes)) : std::nullopt;
}

std::optional<std::string> readText(const FileSource& source, std::string_view path,
                                    Diagnostics& diagnostics) {
  TextFile file = readTextFile(source, path);
  if (file.ok) return std::move(file.bytes);
  if (!file.problem.id.empty()) diagnostics.push_back(std::move(file.problem));
  return std::nullopt;
}

Diagnostic packTextTooLarge(std::string_view path) {
  return tooLarge(path, 1,
                  fmt::format("with this file, the texts of the pack have more than {} bytes; it "
                              "is not read",
                              limits::kPackTextBytes));
}

}  // namespace orris
