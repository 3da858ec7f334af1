#include <orris/render/scene/animated_tiles.h>

#include <orris/gl/functions.h>
#include <orris/world/atlas/atlas_levels.h>

namespace orris {
namespace {

void uploadTile(const gl::Texture& texture, glm::ivec2 corner, const std::vector<Image8>& levels) {
  for (std::size_t i = 0; i < levels.size(); ++i)
    gl::TextureSubImage2D(texture.id(), GLint(i), corner.x >> i, corner.y >> i, levels[i].width,
                          levels[i].height, GL_RGBA, GL_UNSIGNED_BYTE, levels[i].pixels.data());
}

void showMoment(const TileAnimation& animation, const AnimationMoment& moment,
                Image8 TileImages::*map, bool colours, const gl::Texture& texture) {
  const Image8& from = animation.frames[std::size_t(moment.frame)].*map;
  if (from.width == 0) return;
  const Image8& to = animation.frames[std::size_t(moment.next)].*map;
  const Image8 image = moment.share > 0 ? mixed(from, to, moment.share) : from;
  uploadTile(texture, animation.corner,
             colours ? atlasLevels(image, kAtlasLevels) : dataLevels(image, kAtlasLevels));
}

}  // namespace

AnimatedTiles::AnimatedTiles(std::shared_ptr<const TileAnimations> animations)
    : animations_(std::move(animations)) {
  if (!animations_) return;
  for (const TileAnimation& animation : *animations_) shown_.push_back(momentOf(animation, 0));
}

void AnimatedTiles::show(double seconds, const gl::Texture& albedo, const gl::Texture& normals,
                         const gl::Texture& specular) {
  constexpr double kTicksPerSecond = 20;
  const auto tick = long(seconds * kTicksPerSecond);
  if (!animations_ || tick == tick_) return;
  tick_ = tick;
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    const TileAnimation& animation = (*animations_)[i];
    const AnimationMoment moment = momentOf(animation, tick);
    if (moment == shown_[i]) continue;
    shown_[i] = moment;
    showMoment(animation, moment, &TileImages::albedo, true, albedo);
    showMoment(animation, moment, &TileImages::normal, false, normals);
    showMoment(animation, moment, &TileImages::specular, false, specular);
  }
}

}  // namespace orris
