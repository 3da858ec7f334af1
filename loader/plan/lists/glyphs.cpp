// Glyphs of our own for texts: capitals and digits.
#include <cctype>
#include <glm/gtc/matrix_transform.hpp>

#include <orris/plan/lists/list_writer.h>

namespace orris {
namespace {

constexpr int kGlyphColumns = 3, kGlyphRows = 5;
static_assert(kGlyphAdvance == float(kGlyphColumns + 1) / kGlyphRows);

// 3 x 5 squares a glyph, rows from the top, three bits each: A to Z, then 0 to 9.
constexpr std::uint16_t kGlyphs[] = {
    0x2bed, 0x6bae, 0x3923, 0x6b6e, 0x79a7, 0x79a4, 0x396b, 0x5bed, 0x7497, 0x126a, 0x5bad, 0x4927,
    0x5fed, 0x6b6d, 0x2b6a, 0x6ba4, 0x2b7b, 0x6bad, 0x388e, 0x7492, 0x5b6f, 0x5b6a, 0x5bfd, 0x5aad,
    0x5a92, 0x72a7, 0x7b6f, 0x2c97, 0x62a7, 0x728e, 0x5bc9, 0x79cf, 0x39ef, 0x7292, 0x7bef, 0x7bcf};

std::uint16_t glyphOf(char c) {
  const int upper = std::toupper(static_cast<unsigned char>(c));
  if (upper >= 'A' && upper <= 'Z') return kGlyphs[upper - 'A'];
  if (upper >= '0' && upper <= '9') return kGlyphs[26 + upper - '0'];
  return 0;
}

}  // namespace

float glyphsWidth(std::string_view text) {
  const auto glyphs = static_cast<float>(text.size());
  return std::max(0.0f, glyphs * (kGlyphColumns + 1) - 1) / kGlyphRows;
}

void addGlyphs(ListWriter& writer, std::string_view text, const glm::mat4& place,
               ContentQuad square) {
  constexpr int kSquares = kGlyphColumns * kGlyphRows;
  const glm::mat4 squares = glm::scale(place, glm::vec3(1.0f / kGlyphRows));
  const float left = -glyphsWidth(text) * kGlyphRows / 2;
  for (std::size_t g = 0; g < text.size(); ++g) {
    const std::uint16_t glyph = glyphOf(text[g]);
    for (int bit = 0; bit < kSquares; ++bit) {
      if ((glyph >> (kSquares - 1 - bit) & 1) == 0) continue;
      const glm::vec2 at(
          left + static_cast<float>(g * (kGlyphColumns + 1)) + static_cast<float>(bit % kGlyphColumns),
          kGlyphRows / 2.0f - 1 - static_cast<float>(bit / kGlyphColumns));
      const glm::vec2 corners[] = {{0, 1}, {0, 0}, {1, 0}, {1, 1}};
      for (std::size_t i = 0; i < 4; ++i)
        square.corners[i] = glm::vec3(squares * glm::vec4(at + corners[i], 0, 1));
      writer.quad(square);
    }
  }
}

}  // namespace orris
