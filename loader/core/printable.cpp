#include <orris/core/printable.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace orris {
namespace {

/// Length of the UTF-8 sequence at the start of `text`, 0 when there is none. Overlong forms,
/// surrogates and values above U+10FFFF are none.
std::size_t utf8Length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const bool wrong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xED && byte(1) > 0x9F) ||
                     (lead == 0xF0 && byte(1) < 0x90) || (lead == 0xF4 && byte(1) > 0x8F);
  return wrong ? 0 : length;
}

/// Of a sequence of at most three bytes; longer ones are of no interest here.
std::uint32_t codePoint(std::string_view sequence) {
  const auto byte = [&](std::size_t i) {
    return std::uint32_t(static_cast<unsigned char>(sequence[i]));
  };
  if (sequence.size() == 1) return byte(0);
  if (sequence.size() == 2) return (byte(0) & 0x1F) << 6 | (byte(1) & 0x3F);
  if (sequence.size() > 3) return 0x10000;
  return (byte(0) & 0x0F) << 12 | (byte(1) & 0x3F) << 6 | (byte(2) & 0x3F);
}

struct Range {
  std::uint32_t first, last;
};
// C0 without the tab, DEL and C1 (8-bit escapes of terminals), the separators of lines that some
// viewers obey, and the marks of direction that make text read other than it is.
constexpr Range kHidden[] = {{0x00, 0x08},     {0x0A, 0x1F},     {0x7F, 0x9F},    {0x200E, 0x200F},
                             {0x2028, 0x202E}, {0x2066, 0x2069}, {0xFEFF, 0xFEFF}};

std::string shown(std::string_view sequence) {
  const std::uint32_t code = codePoint(sequence);
  const bool hidden = std::any_of(std::begin(kHidden), std::end(kHidden), [code](const Range& r) {
    return code >= r.first && code <= r.last;
  });
  if (!hidden) return std::string(sequence);
  if (code == '\n') return "\\n";
  if (code == '\r') return "\\r";
  return code < 0x100 ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
}

/// "##[group]" of GitHub and Azure, "##vso[task...]", "##teamcity[...]".
void disarmBrackets(std::string& line) {
  for (std::size_t at = 0; (at = line.find("##", at)) != std::string::npos;) {
    std::size_t end = at + 2;
    while (end < line.size() && std::string_view("[]# \t").find(line[end]) == std::string::npos) ++end;
    if (end < line.size() && line[end] == '[') line.replace(at + 1, 1, "\\x23");
    ++at;
  }
}

/// "::error::" of GitHub, whose runner leaves blanks before it out.
void disarmColons(std::string& line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin != std::string::npos && line.compare(begin, 2, "::") == 0)
    line.replace(begin, 1, "\\x3a");
}

}  // namespace

std::string validUtf8(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = utf8Length(text);
    result += length == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(1, length));
  }
  return result;
}

std::string printable(std::string_view text) {
  std::string result;
  const std::string valid = validUtf8(text);
  for (std::string_view rest = valid; !rest.empty();) {
    const std::size_t length = utf8Length(rest);
    result += shown(rest.substr(0, length));
    rest.remove_prefix(length);
  }
  disarmBrackets(result);
  disarmColons(result);
  return result;
}

std::string printableLines(std::string_view text) {
  std::string result;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    result += printable(text.substr(begin, end - begin));
    if (end < text.size()) result += '\n';
    begin = end + 1;
  }
  return result;
}

}  // namespace orris
