#include <orris/world/atlas/texture_canvas.h>

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

/// Integer hash (the constants are odd numbers with well mixed bits; any would do).
std::uint32_t mix(std::uint32_t value) {
  value ^= value >> 16;
  value *= 0x7feb352du;
  value ^= value >> 15;
  value *= 0x846ca68bu;
  return value ^ (value >> 16);
}

TextureCanvas checker() {
  TextureCanvas canvas;
  for (int y = 0; y < kTextureSize; ++y) {
    for (int x = 0; x < kTextureSize; ++x) {
      const bool magenta = (x / 8 + y / 8) % 2 == 0;
      canvas.at(x, y).colour = magenta ? glm::vec4(1, 0, 1, 1) : glm::vec4(0, 0, 0, 1);
    }
  }
  return canvas;
}

/// Surface values that a definition sets for the whole texture.
void applySurface(TextureCanvas& canvas, const RecipeInput& input) {
  const auto& numbers = input.definition.numbers;
  for (Texel& texel : canvas.texels) {
    if (numbers.count("smoothness")) texel.smoothness = input.number("smoothness", 0);
    if (numbers.count("metal")) texel.reflectance = int(input.number("metal", 0));
    if (numbers.count("porosity")) texel.porosity = int(input.number("porosity", 0));
    texel.emission *= input.number("glow", 0);
  }
}

}  // namespace

TextureNoise::TextureNoise(std::string_view name) : seed_(2166136261u) {
  for (const char c : name) seed_ = (seed_ ^ std::uint8_t(c)) * 16777619u;
}

float TextureNoise::white(int x, int y, int salt) const {
  const auto position = std::uint32_t(x & 15) | std::uint32_t(y & 15) << 4;
  return float(mix(seed_ ^ mix(position + std::uint32_t(salt) * 256u)) >> 8) / float(1u << 24);
}

float TextureNoise::smooth(int x, int y, int cell, int salt) const {
  const int x0 = (x & 15) / cell, y0 = (y & 15) / cell, count = 16 / cell;
  const float fx = float((x & 15) % cell) / float(cell), fy = float((y & 15) % cell) / float(cell);
  const auto lattice = [&](int i, int j) { return white(i % count, j % count, salt + cell); };
  const float top = glm::mix(lattice(x0, y0), lattice(x0 + 1, y0), fx);
  const float bottom = glm::mix(lattice(x0, y0 + 1), lattice(x0 + 1, y0 + 1), fx);
  return glm::mix(top, bottom, fy) * 2 - 1;
}

glm::vec4 RecipeInput::colour(size_t i) const {
  const auto& colours = definition.colours;
  return i < colours.size() ? glm::vec4(colours[i]) / 255.0f : glm::vec4(0.5f, 0.5f, 0.5f, 1);
}

float RecipeInput::number(const char* key, float fallback) const {
  const auto found = definition.numbers.find(key);
  return found == definition.numbers.end() ? fallback : found->second;
}

TextureCanvas drawTexture(const std::string& name) {
  constexpr std::string_view kQuarterTurn = "@90";
  if (name.ends_with(kQuarterTurn)) {
    return turned(drawTexture(name.substr(0, name.size() - kQuarterTurn.size())));
  }
  const auto found = blockData().textures.find(name);
  if (found == blockData().textures.end()) return checker();
  const TextureDefinition& definition = found->second;
  TextureRecipe recipe = findMaterialRecipe(definition.recipe);
  if (!recipe) recipe = findObjectRecipe(definition.recipe);
  if (!recipe) return checker();
  TextureCanvas canvas = definition.base.empty() ? TextureCanvas{} : drawTexture(definition.base);
  const RecipeInput input{definition, TextureNoise(name)};
  recipe(canvas, input);
  applySurface(canvas, input);
  return canvas;
}

TextureRecipe findRecipe(std::span<const NamedRecipe> recipes, std::string_view name) {
  const auto found = std::ranges::find(recipes, name, &NamedRecipe::name);
  return found == recipes.end() ? nullptr : found->recipe;
}

TextureCanvas turned(const TextureCanvas& canvas) {
  TextureCanvas result;
  for (int y = 0; y < kTextureSize; ++y) {
    for (int x = 0; x < kTextureSize; ++x) result.at(15 - y, x) = canvas.at(x, y);
  }
  return result;
}

}  // namespace orris
