#include <orris/world/atlas/tile_animation.h>

#include <cmath>

namespace orris {

AnimationMoment momentOf(const TileAnimation& animation, long tick) {
  long period = 0;
  for (const AnimationStep& step : animation.steps) period += step.ticks;
  tick %= period;
  std::size_t i = 0;
  for (; tick >= animation.steps[i].ticks; ++i) tick -= animation.steps[i].ticks;
  const AnimationStep& step = animation.steps[i];
  AnimationMoment moment{step.frame, step.frame, 0};
  if (!animation.interpolate) return moment;
  moment.next = animation.steps[(i + 1) % animation.steps.size()].frame;
  moment.share = float(tick) / float(step.ticks);
  return moment;
}

Image8 mixed(const Image8& from, const Image8& to, float share) {
  Image8 result = from;
  for (std::size_t i = 0; i < result.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const float value = std::lerp(float(from.pixels[i]), float(to.pixels[i]), share);
    result.pixels[i] = std::uint8_t(std::lround(value));
  }
  return result;
}

}  // namespace orris
