// A 16x16 texture while it is drawn: colour and the surface that the normal and specular maps come
// from.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>

#include <orris/world/blocks/block_data.h>

namespace orris {

struct Texel {
  glm::vec4 colour{0};      ///< display rgb and alpha, 0..1
  float height = 0.5f;      ///< 0..1
  float smoothness = 0.1f;  ///< LabPBR perceptual smoothness, 0..1
  int reflectance = 10;     ///< LabPBR green channel: F0 * 255 up to 229, metals from 230
  int porosity = 0;         ///< LabPBR blue channel: porosity to 64, subsurface from 65
  float emission = 0;       ///< 0..1
};

inline constexpr int kTextureSize = 16;  ///< texels a side

/// Coordinates wrap, row 0 on top.
struct TextureCanvas {
  std::array<Texel, kTextureSize * kTextureSize> texels;
  Texel& at(int x, int y) { return texels[index(x, y)]; }
  const Texel& at(int x, int y) const { return texels[index(x, y)]; }

 private:
  static size_t index(int x, int y) { return size_t((y & 15) * kTextureSize + (x & 15)); }
};

/// Values that depend on the texture's name alone.
class TextureNoise {
 public:
  explicit TextureNoise(std::string_view name);
  /// 0..1, unrelated from one position to the next.
  float white(int x, int y, int salt = 0) const;
  /// -1..1, smooth, repeating over the tile; `cell` texels (1, 2, 4, 8) between lattice points.
  float smooth(int x, int y, int cell, int salt = 0) const;

 private:
  std::uint32_t seed_;
};

/// Parameters of one texture for its recipe.
struct RecipeInput {
  const TextureDefinition& definition;
  TextureNoise noise;
  glm::vec4 colour(size_t i) const;  ///< grey when the definition has fewer
  float number(const char* key, float fallback) const;
};

/// Draws a texture; magenta and black squares for one the data file does not define.
TextureCanvas drawTexture(const std::string& name);

/// A quarter turn clockwise.
TextureCanvas turned(const TextureCanvas& canvas);

using TextureRecipe = void (*)(TextureCanvas&, const RecipeInput&);
struct NamedRecipe {
  std::string_view name;
  TextureRecipe recipe;
};
/// nullptr when there is no such recipe.
TextureRecipe findRecipe(std::span<const NamedRecipe> recipes, std::string_view name);
TextureRecipe findMaterialRecipe(std::string_view name);  ///< whole surfaces
TextureRecipe findObjectRecipe(std::string_view name);    ///< plants, doors, lamps, drawn art

}  // namespace orris
