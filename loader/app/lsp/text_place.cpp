#include "app/lsp/text_place.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include <orris/core/characters.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kScheme = "file://";

/// UTF-16 units of the character that begins with this byte; 0 within a character.
std::size_t unitsAt(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  if ((code & 0xC0u) == 0x80u) return 0;
  return code >= 0xF0u ? 2 : 1;
}

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char low = char(std::tolower(static_cast<unsigned char>(c)));
  return low >= 'a' && low <= 'f' ? low - 'a' + 10 : -1;
}

}  // namespace

std::size_t bytesOf(std::string_view line, std::size_t units, bool utf8) {
  if (utf8) return std::min(units, line.size());
  std::size_t count = 0, at = 0;
  while (at < line.size() && count < units) count += unitsAt(line[at++]);
  while (at < line.size() && unitsAt(line[at]) == 0) ++at;
  return at;
}

std::size_t unitsOf(std::string_view line, std::size_t bytes, bool utf8) {
  if (utf8) return bytes;
  std::size_t count = 0;
  for (const char byte : line.substr(0, bytes)) count += unitsAt(byte);
  return count;
}

LineWord wordAround(std::string_view line, std::size_t at, std::string_view more) {
  const auto belongs = [&](char c) {
    return isWordCharacter(c) || more.find(c) != std::string_view::npos;
  };
  LineWord word;
  word.begin = word.end = std::min(at, line.size());
  while (word.begin > 0 && belongs(line[word.begin - 1])) --word.begin;
  while (word.end < line.size() && belongs(line[word.end])) ++word.end;
  word.text = line.substr(word.begin, word.end - word.begin);
  return word;
}

std::string pathOfUri(std::string_view uri) {
  if (!uri.starts_with(kScheme)) return "";
  uri.remove_prefix(kScheme.size());
  if (uri.starts_with("localhost/")) uri.remove_prefix(std::string_view("localhost").size());
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool coded = uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 &&
                       hexDigit(uri[i + 2]) >= 0;
    if (!coded) {
      path += uri[i];
      continue;
    }
    path += char(hexDigit(uri[i + 1]) * 16 + hexDigit(uri[i + 2]));
    i += 2;
  }
  return path;
}

std::string uriOfPath(std::string_view path) {
  constexpr std::string_view kPlain = "/-._~";
  std::string uri(kScheme);
  for (const char c : path) {
    const auto code = static_cast<unsigned char>(c);
    if (std::isalnum(code) != 0 || kPlain.find(c) != std::string_view::npos)
      uri += c;
    else
      uri += fmt::format("%{:02X}", code);
  }
  return uri;
}

nlohmann::json rangeJson(int line, std::size_t begin, std::size_t end) {
  return {{"start", {{"line", line}, {"character", begin}}},
          {"end", {{"line", line}, {"character", end}}}};
}

}  // namespace orris
