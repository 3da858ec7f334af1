// Shadow volumes of lamps: of the few that light the eye's place most, each counted apart in the
// stencil and kept as one bit a pixel.
//
// What a lamp cannot reach costs nothing: its casters are those within its range, and it is counted
// only where the picture may show something within it.
#pragma once

#include <memory>

#include <orris/pack/properties/volume_lights.h>
#include <orris/plan/frame/frame_state.h>
#include <orris/render/scene/gpu_scene.h>
#include <orris/render/scene/shadow_volumes.h>
#include <orris/world/mesh/mesh_lamps.h>

namespace orris {

/// Part of a picture in pixels, from its lower left corner.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelRect&) const = default;
};
/// Where a ball may be seen; empty if nowhere. `clip` takes the ball's space.
PixelRect rectOfBall(const glm::mat4& clip, const glm::vec3& middle, float radius, int width,
                     int height);

class LampVolumes {
 public:
  LampVolumes(const SceneData& scene, const VolumeLightSettings& settings);
  /// Blocks changed.
  void setScene(const SceneData& scene);

  /// Chooses the lamps of a frame: strongest at the eye first, equals by place.
  VolumeLights choose(const glm::dvec3& eye);

  struct View {
    glm::mat4 clip{1};  ///< takes what is relative to `base`
    glm::ivec3 base{0};  ///< as of ShadowVolumes::draw
    EyePyramid eye;
    int width = 0, height = 0;
    VolumeMethod method = VolumeMethod::Auto;
  };
  /// Bit i of the colour of the bound framebuffer, which holds 0, where a volume of lamp i is; the
  /// stencil is used up. `program` as ShadowVolumes::draw.
  void draw(const gl::Program& program, const View& view);

  int builds() const { return builds_; }  ///< lamps whose volumes were made since the start

 private:
  float rangeOf(const MeshLamp& lamp) const { return float(lamp.level) * settings_.range; }
  void keepOnly(const std::vector<MeshLamp>& chosen);
  void resolve(int bit);

  VolumeLightSettings settings_;
  CasterSet casters_;
  std::vector<MeshLamp> lamps_, chosen_;
  std::vector<std::unique_ptr<ShadowVolumes>> volumes_;  ///< of chosen_
  gl::Program resolve_;
  int builds_ = 0;
};

}  // namespace orris
