#include <orris/plan/frame/fog.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <string_view>

#include <orris/world/content/stated_values.h>

namespace orris {
namespace {

enum Fluid { kWater = 1, kLava = 2, kPowderSnow = 3 };  // isEyeInWater
constexpr std::string_view kNamespace = "minecraft:";
constexpr int kFirstSkyStage = 1, kStarsStage = 6, kLastSkyStage = 7;

bool isFoggyPlace(const FrameState& state) {
  return state.environment.dimension == "minecraft:the_nether" ||
         valueIn(state.environment.stated, *findStated("heavyFog"))[0] != 0;
}

FogRange rangeInWater(const FrameState& state, float far) {
  // Of an eye that has been in the water for long.
  constexpr float kBegin = -8, kSight = 96, kMurky = 0.85f;
  const std::string_view biome = state.environment.biome;
  const bool murky = biome.ends_with("swamp");
  return {kBegin, std::min(far, murky ? kSight * kMurky : kSight)};
}

/// Of an effect that draws the fog from `far` to `near` as it sets in; the sky's ends sooner by `skyShare`.
FogRange rangeOfEffect(float effect, float far, float near, float startShare, float skyShare, bool sky) {
  const float end = far + (near - far) * std::clamp(effect, 0.0f, 1.0f);
  return sky ? FogRange{0, end * skyShare} : FogRange{end * startShare, end};
}

FogRange rangeOf(const FrameState& state, bool sky) {
  const auto far = static_cast<float>(state.environment.renderDistance);
  const Player& player = state.environment.player;
  if (state.isEyeInWater == kLava) return {0.25f, 1};
  if (state.isEyeInWater == kPowderSnow) return {0, 2};
  if (player.blindness > 0) return rangeOfEffect(player.blindness, far, 5, 0.25f, 0.8f, sky);
  if (player.darkness > 0) return rangeOfEffect(player.darkness, far, 15, 0.75f, 1, sky);
  if (state.isEyeInWater == kWater) return rangeInWater(state, far);
  if (isFoggyPlace(state)) return {far * 0.05f, std::min(far, 192.0f) * 0.5f};
  return {sky ? 0 : far - std::clamp(far / 10, 4.0f, 64.0f), far};
}

glm::vec3 rgb(unsigned color) { return glm::vec3(color >> 16, color >> 8 & 255, color & 255) / 255.0f; }

/// Biomes whose water has not the fog of the others; without "minecraft:".
glm::vec3 fogOfWater(std::string_view biome) {
  struct Row {
    std::string_view biome;
    unsigned color;
  };
  static constexpr Row kRows[] = {{"swamp", 0x232317},          {"mangrove_swamp", 0x4d7a60},
                                  {"warm_ocean", 0x041f33},     {"lukewarm_ocean", 0x041633},
                                  {"deep_lukewarm_ocean", 0x041633}, {"cherry_grove", 0x5db7ef}};
  constexpr unsigned kOthers = 0x050533;
  biome.remove_prefix(biome.starts_with(kNamespace) ? kNamespace.size() : 0);
  const auto* row = std::ranges::find(kRows, biome, &Row::biome);
  return rgb(row == std::end(kRows) ? kOthers : row->color);
}

/// Towards the brightest colour of the same hue.
glm::vec3 brightened(const glm::vec3& color, float share) {
  if (color.r <= 0 || color.g <= 0 || color.b <= 0) return color;
  return glm::mix(color, color / std::max({color.r, color.g, color.b}), share);
}

}  // namespace

FogRange fogRangeOf(const FrameState& state, int renderStage) {
  FogRange range = rangeOf(state, renderStage >= kFirstSkyStage && renderStage <= kLastSkyStage);
  if (renderStage == kStarsStage) range.start = std::numeric_limits<float>::max();
  return range;
}

glm::vec3 fogColorOf(const FrameState& state) {
  const Player& player = state.environment.player;
  if (state.isEyeInWater == kLava) return {0.6f, 0.1f, 0};
  if (state.isEyeInWater == kPowderSnow) return brightened({0.623f, 0.734f, 0.785f}, player.nightVision);
  const bool water = state.isEyeInWater == kWater;
  const float sight = 1 - std::clamp(player.blindness > 0 ? player.blindness : player.darkness, 0.0f, 1.0f);
  const glm::vec3 color = (water ? fogOfWater(state.environment.biome) : state.environment.fogColor) * sight * sight;
  return brightened(color, water ? 1 : player.darkness > 0 ? 0 : player.nightVision);
}

float fogDensityOf(const FrameState& state) { return state.isEyeInWater == kWater ? 0.02f : 0.0f; }

int fogShapeOf(const FrameState& state) {
  const Player& player = state.environment.player;
  const bool around = state.isEyeInWater != 0 || player.blindness > 0 || player.darkness > 0;
  return around || isFoggyPlace(state) ? 0 : 1;
}

}  // namespace orris
