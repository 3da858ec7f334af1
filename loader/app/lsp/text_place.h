// Places in texts as editors count them, words there, and files as URIs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// From 0; `at` counts bytes of the line.
struct TextPlace {
  int line = 0;
  std::size_t at = 0;
};

/// A word in a line, by bytes.
struct LineWord {
  std::size_t begin = 0, end = 0;
  std::string text;
};

/// Editors count UTF-16 units where they do not say that they can take bytes.
std::size_t bytesOf(std::string_view line, std::size_t units, bool utf8);
std::size_t unitsOf(std::string_view line, std::size_t bytes, bool utf8);

/// The word around a byte of the line, of letters, digits, "_" and the characters of `more`.
LineWord wordAround(std::string_view line, std::size_t at, std::string_view more = "");

/// "file:///a%20b" -> "/a b"; "" for other schemes.
std::string pathOfUri(std::string_view uri);
std::string uriOfPath(std::string_view path);

nlohmann::json rangeJson(int line, std::size_t begin, std::size_t end);

}  // namespace orris
