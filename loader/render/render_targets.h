// The textures of a schedule: colortex and shadowcolor (main and alt), depth, shadow depth, screen.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <orris/gl/framebuffer.h>
#include <orris/gl/texture.h>
#include <orris/plan/schedule/schedule.h>

namespace orris {

/// One colortex or shadowcolor on the GPU.
struct RenderTarget {
  TargetPlan plan;
  const TextureFormat* format = nullptr;
  gl::Texture sides[2];                ///< main, alt (alt only when the plan needs it)
  bool mipmapped[2] = {false, false};  ///< mipmaps built since the frame began
  bool isFresh = true;                 ///< holds nothing yet
  const gl::Texture& side(bool alt) const { return sides[alt && plan.needsAlt ? 1 : 0]; }
};

class RenderTargets {
 public:
  /// `floatScreen`: the screen keeps values beyond 0..1 (for EXR). Unknown or unusable formats are
  /// diagnostics. Colour targets that `previous` has just so are shared with it, and keep what they
  /// hold.
  RenderTargets(const Schedule& schedule, bool floatScreen, const RenderTargets* previous,
                Diagnostics& diagnostics);

  RenderTarget* find(bool shadow, int index);
  const gl::Texture& depth(int index) const { return depth_[index]; }
  /// The stencil of depth(0); id 0 without shadow volumes.
  const gl::Texture& stencil() const { return stencil_; }
  /// stenciltex1: a bit for each lamp with volumes; id 0 where none is read.
  const gl::Texture& lampShadows() const { return lampShadows_; }
  const gl::Texture& shadowDepth(int index) const { return shadowDepth_[index]; }
  const gl::Texture& screen() const { return screen_; }

  /// Framebuffer of what a step writes; made once. id 0 and a message in `error` on failure.
  const gl::Framebuffer& framebuffer(const Step& step, std::string& error);
  const gl::Framebuffer& screenFramebuffer();
  /// lampShadows() over the depth.
  const gl::Framebuffer& lampFramebuffer();

  /// Every side of what holds nothing yet to its clear colour (first use, resize), and the depth.
  void clearFresh(const float fogColor[3]);
  /// What a frame clears: colour buffers with clear=true, both sides, and the depth.
  void clearColor(const float fogColor[3]);
  void clearShadow();
  /// Copies alt into main where the schedule says so.
  void keepHistory();
  void forgetMipmaps();

 private:
  void clearTarget(RenderTarget& target, const float fogColor[3]);
  using Targets = std::map<int, std::shared_ptr<RenderTarget>>;
  static Targets makeTargets(const std::vector<TargetPlan>& plans, const char* kind,
                             const Targets* previous, Diagnostics& diagnostics);
  Targets color_, shadowColor_;
  gl::Texture depth_[3], stencil_, lampShadows_, shadowDepth_[2], screen_;
  std::map<std::string, gl::Framebuffer> framebuffers_;
};

}  // namespace orris
