// Shows the moment of animated textures in the atlases on the GPU.
#pragma once

#include <memory>
#include <vector>

#include <orris/gl/texture.h>
#include <orris/world/atlas/tile_animation.h>

namespace orris {

class AnimatedTiles {
 public:
  AnimatedTiles() = default;
  /// nullptr: nothing changes.
  explicit AnimatedTiles(std::shared_ptr<const TileAnimations> animations);
  /// Uploads what differs from the last call, the first moment before any. `seconds`: since the start.
  void show(double seconds, const gl::Texture& albedo, const gl::Texture& normals,
            const gl::Texture& specular);

 private:
  std::shared_ptr<const TileAnimations> animations_;
  std::vector<AnimationMoment> shown_;
  long tick_ = 0;
};

}  // namespace orris
