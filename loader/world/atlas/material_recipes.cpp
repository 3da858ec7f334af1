// Recipes for surfaces that fill their tile.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <orris/world/atlas/texture_canvas.h>

namespace orris {
namespace {

glm::vec4 shade(const glm::vec4& colour, float factor) {
  return {glm::clamp(glm::vec3(colour) * factor, 0.0f, 1.0f), colour.a};
}

/// Calls `draw(x, y, texel)` for the whole tile.
template <class Draw>
void forEachTexel(TextureCanvas& canvas, Draw draw) {
  for (int y = 0; y < kTextureSize; ++y) {
    for (int x = 0; x < kTextureSize; ++x) draw(x, y, canvas.at(x, y));
  }
}

/// Fine and coarse noise together, about -1..1.
float grainAt(const RecipeInput& in, int x, int y, int salt = 0) {
  return 0.6f * (in.noise.white(x, y, salt) * 2 - 1) + 0.4f * in.noise.smooth(x, y, 4, salt);
}

/// Noise over colour 0; patches of colour 1 over the share `patches`.
void grain(TextureCanvas& canvas, const RecipeInput& in) {
  const float amount = in.number("amount", 0.1f), patches = in.number("patches", 0);
  const int cell = int(in.number("cell", 4));
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const float g = grainAt(in, x, y);
    const bool patch = patches > 0 && in.noise.smooth(x, y, cell, 7) + 0.3f * g > 1 - 2 * patches;
    texel.colour = shade(in.colour(patch ? 1 : 0), 1 + amount * g);
    texel.height = 0.5f + 0.3f * g * std::min(1.0f, amount * 6);
    texel.emission = patch || patches == 0 ? 1 : 0.15f;
  });
}

/// Four boards with seams; the grain runs along them.
void planks(TextureCanvas& canvas, const RecipeInput& in) {
  constexpr std::array<int, 4> kEnds{7, 15, 3, 11};
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const int board = y / 4;
    const bool seam = y % 4 == 3 || x == kEnds[board];
    const float streak =
        in.noise.smooth(x + board * 5, y, 8, y) * 0.5f + in.noise.white(x / 3, y) - 0.5f;
    const float tone =
        1 + 0.10f * streak + 0.05f * (in.noise.white(board, x > kEnds[board]) - 0.5f);
    texel.colour = shade(in.colour(0), seam ? 0.66f * tone : y % 4 == 0 ? 1.07f * tone : tone);
    texel.height = seam ? 0.2f : 0.6f + 0.1f * streak;
    texel.smoothness = 0.2f;
  });
}

/// Bricks of `width` by `rows` texels, every second course moved by half, mortar of colour 1.
void bricks(TextureCanvas& canvas, const RecipeInput& in) {
  const int course = int(in.number("course", 4)), width = int(in.number("width", 8));
  const float amount = in.number("amount", 0.1f);
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const int row = y / course, moved = (x + (row % 2) * width / 2) % kTextureSize;
    const int left = moved % width, top = y % course;
    const bool mortar = left == width - 1 || top == course - 1;
    const float tone = 1 + amount * (in.noise.white(moved / width, row, 3) * 2 - 1) +
                       amount * 0.6f * grainAt(in, x, y);
    const float edge = top == 0 || left == 0 ? 1.08f : 1;
    texel.colour = mortar ? shade(in.colour(1), 1 + 0.06f * grainAt(in, x, y))
                          : shade(in.colour(0), tone * edge);
    texel.height = mortar ? 0.15f : 0.7f + 0.1f * grainAt(in, x, y);
  });
}

/// Rounded stones: the nearest of a dozen points gives the stone, the second nearest the gap.
/// Colour 1 fills the gaps, colour 2 (when given) grows on some stones.
void cobble(TextureCanvas& canvas, const RecipeInput& in) {
  constexpr int kStones = 12;
  const float gap = in.number("gap", 1.1f), moss = in.number("moss", 0);
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    float nearest = 1e9f, second = 1e9f;
    int stone = 0;
    for (int i = 0; i < kStones; ++i) {
      const glm::vec2 point(float(i % 3) * 5.33f + in.noise.white(i, 0, 5) * 4,
                            float(i / 3) * 4 + in.noise.white(i, 1, 5) * 3);
      glm::vec2 d = glm::abs(glm::vec2(x, y) - point);
      d = glm::min(d, 16.0f - d);
      const float distance = std::sqrt(d.x * d.x + d.y * d.y * 1.5f);
      if (distance < nearest) {
        second = std::exchange(nearest, distance);
        stone = i;
      } else {
        second = std::min(second, distance);
      }
    }
    const float rise = std::clamp((second - nearest) / 3, 0.0f, 1.0f);
    const float tone = 0.9f + 0.2f * in.noise.white(stone, 2, 5) + 0.08f * grainAt(in, x, y);
    const bool mossy =
        moss > 0 && in.noise.smooth(x, y, 4, 9) + 0.4f * grainAt(in, x, y, 3) > 1 - 2 * moss;
    const bool inGap = second - nearest < gap;
    texel.colour = shade(in.colour(mossy ? 2 : inGap ? 1 : 0), tone * (0.92f + 0.16f * rise));
    texel.height = 0.2f + 0.6f * std::sqrt(rise);
  });
}

/// One slab with a bevelled edge; `inset` > 0 draws a second frame that far inside.
void polished(TextureCanvas& canvas, const RecipeInput& in) {
  const float amount = in.number("amount", 0.04f);
  const int inset = int(in.number("inset", 0)), split = int(in.number("split", kTextureSize));
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const int u = x % split, v = y % split, last = split - 1;
    const bool light = u == 0 || v == 0, dark = u == last || v == last;
    const int ring = std::min({u, v, last - u, last - v});
    float tone = dark ? 0.82f : light ? 1.1f : 1;
    if (inset > 0 && ring == inset) tone *= u == inset || v == inset ? 0.8f : 1.12f;
    const bool fill = inset > 0 && ring > inset && in.definition.colours.size() > 1;
    const float g = grainAt(in, x, y);
    texel.colour = shade(in.colour(fill ? 1 : 0), tone * (1 + amount * g));
    texel.height = (ring == 0 ? 0.35f : inset > 0 && ring >= inset ? 0.5f : 0.65f) + amount * g;
    texel.smoothness = 0.35f;
    texel.emission = fill ? 1 : 0;
  });
}

/// Base noise of colour 0 with `blobs` spots of colour 1, lighter at their upper left.
void ore(TextureCanvas& canvas, const RecipeInput& in) {
  grain(canvas, in);
  const int blobs = int(in.number("blobs", 6));
  for (Texel& texel : canvas.texels) texel.emission = 0;
  for (int i = 0; i < blobs; ++i) {
    const int cx = (i % 3) * 5 + 1 + int(in.noise.white(i, 0, 11) * 4);
    const int cy = (i / 3) * (15 / ((blobs + 2) / 3)) + 1 + int(in.noise.white(i, 1, 11) * 4);
    for (int k = 0; k < 6; ++k) {
      const int x = cx + k % 3, y = cy + k / 3;
      if (k % 3 == 2 && in.noise.white(x, y, 12) < 0.5f) continue;
      Texel& texel = canvas.at(x, y);
      texel.colour = shade(in.colour(1), k == 0 ? 1.3f : k >= 3 ? 0.78f : 1);
      texel.height = 0.75f;
      texel.smoothness = 0.5f;
      texel.emission = 1;
    }
  }
}

/// Vertical furrows; `bands` adds dark dashes across (birch).
void bark(TextureCanvas& canvas, const RecipeInput& in) {
  const float amount = in.number("amount", 0.3f), bands = in.number("bands", 0);
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const float furrow = in.noise.white(x, 0, 4) - 0.5f + 0.5f * in.noise.smooth(x, y, 4, 5);
    float tone = 1 + amount * furrow + 0.05f * grainAt(in, x, y);
    const int dash = int(in.noise.white(y / 2, 0, 8) * 16);
    if (bands > 0 && y % 3 == 0 && ((x - dash) & 15) < 5) tone *= 0.35f;
    texel.colour = shade(in.colour(0), tone);
    texel.height = 0.5f + 0.4f * furrow;
  });
}

/// The cut end of a log: square year rings of colour 0 inside a rim of colour 1.
void rings(TextureCanvas& canvas, const RecipeInput& in) {
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const int ring = std::max(std::abs(2 * x - 15), std::abs(2 * y - 15)) / 2;
    const bool rim = ring == 7;
    const float tone = (ring % 2 == 0 ? 1.05f : 0.9f) * (1 + 0.05f * grainAt(in, x, y));
    texel.colour = shade(in.colour(rim ? 1 : 0), tone);
    texel.height = rim ? 0.7f : ring % 2 == 0 ? 0.55f : 0.45f;
  });
}

/// Clumps with holes (alpha 0); the share of colour 1 is `blossom`.
void leaves(TextureCanvas& canvas, const RecipeInput& in) {
  const float holes = in.number("holes", 0.28f), blossom = in.number("blossom", 0);
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const float v =
        0.55f * in.noise.white(x, y) + 0.45f * (in.noise.smooth(x, y, 2, 3) * 0.5f + 0.5f);
    const bool flower = in.noise.white(x / 2, y / 2, 6) < blossom;
    texel.colour = shade(in.colour(flower ? 1 : 0), 0.6f + 0.7f * v);
    texel.colour.a = v < holes ? 0.0f : 1.0f;
    texel.height = v;
    texel.porosity = 160;
  });
}

/// A frame of colour 0 around panes whose alpha is that of colour 1, with two glints.
void glass(TextureCanvas& canvas, const RecipeInput& in) {
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const bool frame = x == 0 || y == 0 || x == 15 || y == 15;
    const int diagonal = x + y;
    const bool glint =
        !frame && ((diagonal == 9 && x > 2 && x < 7) || (diagonal == 22 && x > 9 && x < 13) ||
                   (diagonal == 11 && x > 3 && x < 7));
    texel.colour = in.colour(frame || glint ? 0 : 1);
    texel.height = frame ? 0.7f : 0.5f;
    texel.smoothness = 0.95f;
  });
}

/// Colour 0 with a layer of colour 1 hanging over its top `depth` texels, its edge ragged unless
/// `ragged` is 0.
void overhang(TextureCanvas& canvas, const RecipeInput& in) {
  const int depth = int(in.number("depth", 3));
  const float amount = in.number("amount", 0.12f);
  const bool ragged = in.number("ragged", 1) > 0;
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const int edge = ragged ? depth + int(in.noise.white(x, 0, 2) * 2.5f) - 1 : depth;
    const bool layer = y < edge;
    const float g = grainAt(in, x, y);
    texel.colour = shade(in.colour(layer ? 1 : 0), (1 + amount * g) * (y == edge ? 0.8f : 1));
    texel.height = layer ? 0.7f : 0.4f + 0.2f * g;
  });
}

/// Woven or knitted cloth.
void wool(TextureCanvas& canvas, const RecipeInput& in) {
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const bool over = (x / 2 + y / 2) % 2 == 0;
    const bool loop = over ? x % 2 == 0 : y % 2 == 0;
    const float tone = (loop ? 1.05f : 0.93f) + 0.06f * grainAt(in, x, y);
    texel.colour = shade(in.colour(0), tone);
    texel.height = loop ? 0.65f : 0.4f;
    texel.smoothness = 0.02f;
    texel.porosity = 50;
  });
}

/// Colour 0 pulled towards fired clay by `clay`, then darkened by `tone`.
void fired(TextureCanvas& canvas, const RecipeInput& in) {
  const float clay = in.number("clay", 0), tone = in.number("tone", 1);
  const float amount = in.number("amount", 0.02f);
  const glm::vec4 base = glm::mix(in.colour(0), glm::vec4(0.60f, 0.38f, 0.28f, 1), clay);
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const float g = grainAt(in, x, y);
    texel.colour = shade(base, tone * (1 + amount * g));
    texel.height = 0.5f + amount * g;
  });
}

/// Four-fold tile pattern of colour 0 with lines of colour 1.
void glazed(TextureCanvas& canvas, const RecipeInput& in) {
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const int u = std::min(x, 15 - x), v = std::min(y, 15 - y);
    const float pattern = in.noise.white(std::min(u, v), std::max(u, v), 1);
    const glm::vec4 base = pattern < 0.45f  ? in.colour(0)
                           : pattern < 0.7f ? shade(in.colour(0), 0.7f)
                                            : in.colour(1);
    texel.colour = shade(base, 1);
    texel.smoothness = 0.7f;
  });
}

/// Bright cells of colour 0 in a lattice of colour 1.
void lamp(TextureCanvas& canvas, const RecipeInput& in) {
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const float v =
        0.5f + 0.35f * in.noise.smooth(x, y, 4, 2) + 0.3f * (in.noise.white(x, y) - 0.5f);
    const float bright = std::clamp((v - 0.25f) * 1.9f, 0.0f, 1.0f);
    texel.colour = glm::mix(in.colour(1), in.colour(0), bright);
    texel.height = 0.4f + 0.3f * bright;
    texel.smoothness = 0.4f;
    texel.emission = 0.35f + 0.65f * bright;
  });
}

/// Waves of colour 0 towards colour 1; keeps the colours' alpha.
void fluid(TextureCanvas& canvas, const RecipeInput& in) {
  forEachTexel(canvas, [&](int x, int y, Texel& texel) {
    const float v =
        0.5f + 0.5f * (0.6f * in.noise.smooth(x, y, 8, 1) + 0.4f * in.noise.smooth(x, y, 4, 2));
    texel.colour = glm::mix(in.colour(0), in.colour(1), v);
    texel.height = 0.4f + 0.2f * v;
    texel.smoothness = in.number("smoothness", 0.9f);
    texel.emission = 0.6f + 0.4f * v;
  });
}

constexpr std::array kMaterialRecipes{
    NamedRecipe{"grain", grain},   NamedRecipe{"planks", planks},     NamedRecipe{"bricks", bricks},
    NamedRecipe{"cobble", cobble}, NamedRecipe{"polished", polished}, NamedRecipe{"ore", ore},
    NamedRecipe{"bark", bark},     NamedRecipe{"rings", rings},       NamedRecipe{"leaves", leaves},
    NamedRecipe{"glass", glass},   NamedRecipe{"overhang", overhang}, NamedRecipe{"wool", wool},
    NamedRecipe{"fired", fired},   NamedRecipe{"glazed", glazed},     NamedRecipe{"lamp", lamp},
    NamedRecipe{"fluid", fluid},
};

}  // namespace

TextureRecipe findMaterialRecipe(std::string_view name) {
  return findRecipe(kMaterialRecipes, name);
}

}  // namespace orris
