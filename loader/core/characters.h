// Kinds of characters in ASCII, whatever the locale.
#pragma once

namespace orris {

constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
/// A letter, a digit or '_'.
constexpr bool isWordCharacter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || isDigit(c) || c == '_';
}

}  // namespace orris
