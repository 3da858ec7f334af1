// Texts of language files: the game's colour codes, "§aON§r".
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// A part of a text in one look. `color` is 0xRRGGBB.
struct TextRun {
  std::string text;
  std::uint32_t color = 0xFFFFFF;
  bool bold = false;
  bool operator==(const TextRun&) const = default;
};

/// Without the codes; a colour ends a bold part, "§r" all. Italics, underlines and obfuscation are left
/// out, unknown codes too.
std::vector<TextRun> textRuns(std::string_view text);
std::string withoutCodes(std::string_view text);

}  // namespace orris
