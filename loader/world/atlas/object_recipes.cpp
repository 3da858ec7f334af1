// Recipes for plants and things: what does not fill its tile, or has a drawn shape.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <orris/world/atlas/texture_canvas.h>

namespace orris {
namespace {

void paint(TextureCanvas& canvas, int x, int y, const glm::vec4& colour, float tone = 1) {
  if (x < 0 || y < 0 || x >= kTextureSize || y >= kTextureSize) return;
  Texel& texel = canvas.at(x, y);
  texel.colour = {glm::clamp(glm::vec3(colour) * tone, 0.0f, 1.0f), colour.a};
  texel.height = 0.5f + 0.3f * (tone - 1);
  texel.porosity = 120;
}

/// Index of a colour: 0-9, then a-z; nothing for other characters.
std::optional<size_t> colourIndex(char c) {
  if (c >= '0' && c <= '9') return size_t(c - '0');
  if (c >= 'a' && c <= 'z') return size_t(c - 'a' + 10);
  return std::nullopt;
}

/// Drawn rows over what is there already. Colours from `glowFrom` on shine.
void art(TextureCanvas& canvas, const RecipeInput& in) {
  const auto& rows = in.definition.art;
  const auto glowFrom = size_t(in.number("glowFrom", 99));
  for (int y = 0; y < std::min(kTextureSize, int(rows.size())); ++y) {
    const std::string& row = rows[size_t(y)];
    for (int x = 0; x < kTextureSize; ++x) {
      const size_t column = row.size() == 1 ? 0 : size_t(x);
      const std::optional<size_t> index =
          column < row.size() ? colourIndex(row[column]) : std::nullopt;
      if (!index) continue;
      paint(canvas, x, y, in.colour(*index), 1 + 0.08f * (in.noise.white(x, y) - 0.5f));
      Texel& texel = canvas.at(x, y);
      texel.porosity = 0;
      texel.emission = *index >= glowFrom ? 1.0f : 0.0f;
    }
  }
}

/// `blades` stalks of colour 0 from the ground to about `tall` texels, tips of colour 1 where given.
void blades(TextureCanvas& canvas, const RecipeInput& in) {
  const int count = int(in.number("blades", 8)), tall = int(in.number("tall", 12));
  const bool tips = in.definition.colours.size() > 1;
  for (int i = 0; i < count; ++i) {
    const float root = 1 + 14 * (float(i) + 0.5f) / float(count);
    const float lean = (in.noise.white(i, 0, 1) - 0.5f) * in.number("lean", 5);
    const int height = int(float(tall) * (0.6f + 0.4f * in.noise.white(i, 1, 1)));
    const float tone = 0.75f + 0.35f * in.noise.white(i, 2, 1);
    for (int k = 0; k < height; ++k) {
      const float t = float(k) / float(height);
      const int x = int(std::lround(root + lean * t * t));
      const bool tip = tips && t > 0.6f;
      paint(canvas, x, 15 - k, in.colour(tip ? 1 : 0), tone * (0.85f + 0.3f * t));
      if (tip) paint(canvas, x + 1, 15 - k, in.colour(1), tone * 0.85f);
      canvas.at(x, 15 - k).emission = tip ? 1.0f : 0.0f;
    }
  }
}

/// A stem of colour 0 with two leaves and a head of colour 1, its middle colour 2.
void flower(TextureCanvas& canvas, const RecipeInput& in) {
  const int head = int(in.number("head", 7)), radius = int(in.number("radius", 2));
  for (int y = head; y < kTextureSize; ++y)
    paint(canvas, 7 + (y > 12), y, in.colour(0), 1 - 0.02f * float(y - head));
  for (int i = 0; i < 3; ++i) {
    paint(canvas, 6 - i, 12 - i, in.colour(0), 1.1f);
    paint(canvas, 9 + i, 13 - i, in.colour(0), 0.9f);
  }
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      if (std::abs(dx) + std::abs(dy) > radius + radius / 2) continue;
      const bool middle = dx == 0 && dy == 0 && in.definition.colours.size() > 2;
      const float tone = 1.08f - 0.08f * float(dx + dy) / float(radius) +
                         0.1f * (in.noise.white(dx + 8, dy + 8) - 0.5f);
      paint(canvas, 7 + dx, head + dy, in.colour(middle ? 2 : 1), middle ? 1 : tone);
    }
  }
}

/// A trunk of colour 0 under a crown of colour 1 with gaps.
void bush(TextureCanvas& canvas, const RecipeInput& in) {
  const int trunk = int(in.number("trunk", 5)), top = int(in.number("top", 2));
  for (int y = kTextureSize - trunk - 2; y < kTextureSize; ++y) {
    paint(canvas, 7, y, in.colour(0), 1);
    paint(canvas, 8, y, in.colour(0), 0.8f);
  }
  const float middle = float(top + kTextureSize - trunk) / 2,
              half = float(kTextureSize - trunk - top) / 2 + 0.5f;
  for (int y = top; y < kTextureSize - trunk; ++y) {
    for (int x = 1; x < 15; ++x) {
      const glm::vec2 d((float(x) - 7.5f) / 6.5f, (float(y) - middle) / half);
      if (glm::dot(d, d) > 0.75f + 0.5f * in.noise.white(x, y) || in.noise.white(x, y, 2) < 0.18f)
        continue;
      paint(canvas, x, y, in.colour(1), 0.7f + 0.5f * in.noise.white(x, y, 3));
    }
  }
}

/// A stalk of colour 0 and a cap of colour 1.
void mushroom(TextureCanvas& canvas, const RecipeInput& in) {
  for (int y = 11; y < kTextureSize; ++y) {
    paint(canvas, 7, y, in.colour(0), 1);
    paint(canvas, 8, y, in.colour(0), 0.85f);
  }
  for (int y = 7; y < 12; ++y) {
    const int half = y == 7 ? 2 : y == 8 ? 3 : 4;
    for (int x = 8 - half; x < 8 + half; ++x) {
      const bool dot = in.number("dots", 0) > 0 && in.noise.white(x, y) < 0.18f;
      paint(canvas, x, y, in.colour(dot ? 2 : 1), y == 11 ? 0.75f : 1.1f - 0.05f * float(y - 7));
    }
  }
}

/// Hanging or climbing strands of colour 0, colour 1 for their fruit.
void strands(TextureCanvas& canvas, const RecipeInput& in) {
  const float density = in.number("density", 0.5f);
  const bool fruit = in.definition.colours.size() > 1;
  for (int y = 0; y < kTextureSize; ++y) {
    for (int x = 0; x < kTextureSize; ++x) {
      const float v = 0.5f * in.noise.white(x, y) + 0.3f * in.noise.white(x / 2, 0, 3) +
                      0.2f * (in.noise.smooth(x, y, 4, 4) * 0.5f + 0.5f);
      if (v > density) continue;
      const bool berry = fruit && in.noise.white(x / 2, y / 2, 6) < 0.12f;
      paint(canvas, x, y, in.colour(berry ? 1 : 0), 0.75f + 0.5f * in.noise.white(x, y, 2));
      canvas.at(x, y).emission = berry ? 1.0f : 0.0f;
    }
  }
}

/// A board with a frame and `rows` by `columns` sunk panels; down to row `windows` they are empty.
void panels(TextureCanvas& canvas, const RecipeInput& in) {
  const int columns = int(in.number("columns", 2)), rows = int(in.number("rows", 2));
  const int windows = int(in.number("windows", 0));
  const int width = 16 / columns, height = 16 / rows;
  for (int y = 0; y < kTextureSize; ++y) {
    for (int x = 0; x < kTextureSize; ++x) {
      const int u = x % width, v = y % height;
      const int ring = std::min({u, v, width - 1 - u, height - 1 - v});
      const bool window = ring >= 2 && y < windows;
      const float grain = 0.06f * (in.noise.white(x / 3, y) - 0.5f);
      const float tone = ring == 0 ? 0.92f : ring == 1 ? (u == 1 || v == 1 ? 0.78f : 1.1f) : 1;
      paint(canvas, x, y, in.colour(0), tone + grain);
      Texel& texel = canvas.at(x, y);
      texel.porosity = 0;
      texel.height = ring == 0 ? 0.7f : 0.45f;
      if (window) texel.colour.a = 0;
    }
  }
  const int knob = int(in.number("knob", -1));
  if (knob >= 0) paint(canvas, 13, knob, in.colour(1), 1);
}

/// Fire: tongues from colour 0 at the ground to colour 1 at the tips.
void flames(TextureCanvas& canvas, const RecipeInput& in) {
  for (int x = 0; x < kTextureSize; ++x) {
    const float height =
        6 + 9 * in.noise.white(x / 2, 0, 1) * (0.6f + 0.4f * in.noise.white(x, 0, 2));
    for (int k = 0; float(k) < height; ++k) {
      const float t = float(k) / height;
      if (t > 0.5f && in.noise.white(x, k, 3) < 0.3f) continue;
      paint(canvas, x, 15 - k, glm::mix(in.colour(0), in.colour(1), t), 1);
      canvas.at(x, 15 - k).emission = 1;
    }
  }
}

/// Bars of colour 0: `step` texels apart, across too when `grid` is set.
void bars(TextureCanvas& canvas, const RecipeInput& in) {
  const int step = int(in.number("step", 4));
  const bool grid = in.number("grid", 0) > 0;
  for (int y = 0; y < kTextureSize; ++y) {
    for (int x = 0; x < kTextureSize; ++x) {
      const bool upright = x % step == step / 2,
                 level = grid ? y % step == step / 2 : y == 2 || y == 13;
      if (upright || level) paint(canvas, x, y, in.colour(0), upright ? 1 : 0.8f);
      canvas.at(x, y).porosity = 0;
    }
  }
}

constexpr std::array kObjectRecipes{
    NamedRecipe{"art", art},           NamedRecipe{"blades", blades},
    NamedRecipe{"flower", flower},     NamedRecipe{"bush", bush},
    NamedRecipe{"mushroom", mushroom}, NamedRecipe{"strands", strands},
    NamedRecipe{"panels", panels},     NamedRecipe{"flames", flames},
    NamedRecipe{"bars", bars},
};

}  // namespace

TextureRecipe findObjectRecipe(std::string_view name) { return findRecipe(kObjectRecipes, name); }

}  // namespace orris
