#include <orris/plan/frame/fog.h>

#include <algorithm>
#include <limits>
#include <string_view>

#include <orris/world/content/stated_values.h>

namespace orris {
namespace {

enum Fluid { kWater = 1, kLava = 2, kPowderSnow = 3 };  // isEyeInWater
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

}  // namespace

FogRange fogRangeOf(const FrameState& state, int renderStage) {
  FogRange range = rangeOf(state, renderStage >= kFirstSkyStage && renderStage <= kLastSkyStage);
  if (renderStage == kStarsStage) range.start = std::numeric_limits<float>::max();
  return range;
}

float fogDensityOf(const FrameState& state) { return state.isEyeInWater == kWater ? 0.02f : 0.0f; }

int fogShapeOf(const FrameState& state) {
  const Player& player = state.environment.player;
  const bool around = state.isEyeInWater != 0 || player.blindness > 0 || player.darkness > 0;
  return around || isFoggyPlace(state) ? 0 : 1;
}

}  // namespace orris
