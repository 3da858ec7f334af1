// Shadow volumes on the GPU: silhouettes made when light or blocks change, drawn into the stencil.
//
// Depth clamp takes the near and far planes away, so that z-pass counts from the eye itself and
// nothing at infinity is lost. z-pass is wrong by the number of volumes that the eye is in; AUTO finds
// their faces and counts these volumes again without depth test, which adds just that number: pixel
// for pixel the result of z-fail for them, at the cost of z-pass for all others.
#pragma once

#include <array>
#include <optional>

#include <orris/gl/buffer.h>
#include <orris/gl/program.h>
#include <orris/world/mesh/silhouette.h>

namespace orris {

/// How volumes are counted: those between eye and surface; those behind it; each as it must.
enum class VolumeMethod { Auto, ZPass, ZFail };
/// Value of shadowvolume.method, Auto for any other word.
VolumeMethod volumeMethodOf(const std::string& word);

/// The eye and the corners of the near rectangle, world blocks.
using EyePyramid = std::array<glm::dvec3, 5>;

/// Does the volume of a face that makes one reach the pyramid? False only if it does not.
bool reachesEye(const CasterFace& face, const VolumeLight& light, const EyePyramid& eye);

class ShadowVolumes {
 public:
  explicit ShadowVolumes(CasterSet casters) : casters_(std::move(casters)) {}
  /// Blocks changed.
  void setCasters(CasterSet casters);

  /// Draws for a light into the bound framebuffer, whose stencil holds 0 and whose depth is the
  /// scene's; `program` is in use, matrices take positions relative to `base`, a block near the eye: where
  /// coordinates are large, the depths of a volume and of the face that makes it are rounded apart, and the face
  /// shades itself.
  void draw(const gl::Program& program, const VolumeLight& light, const EyePyramid& eye,
            const glm::ivec3& base, VolumeMethod method);

  int facesAtEye() const { return facesAtEye_; }  ///< counted apart in the last draw
  int builds() const { return builds_; }          ///< silhouettes made since the start

 private:
  struct Drawn {
    gl::Buffer vertices, indices;
    std::vector<glm::vec4> corners;  ///< relative to the casters' origin
    std::optional<glm::ivec3> base;  ///< what `vertices` are relative to
    std::uint32_t indexCount = 0, alongCount = 0;
  };
  static Drawn upload(VolumeMesh mesh);
  void moveTo(const glm::ivec3& base, Drawn& drawn) const;
  Drawn& silhouettes(const VolumeLight& light, bool closed);
  Drawn& nearEye(const VolumeLight& light, const EyePyramid& eye);
  void forget();

  CasterSet casters_;
  std::optional<VolumeLight> light_;  ///< what the rest was made for
  std::optional<Drawn> sides_, closed_, nearEye_;
  std::vector<const CasterFace*> makers_;     ///< faces that make volumes
  std::vector<const CasterFace*> nearFaces_;  ///< of them, those in nearEye_
  int facesAtEye_ = 0, builds_ = 0;
};

}  // namespace orris
