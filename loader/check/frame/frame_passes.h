// The programs of a folder in frame order with what each reads and writes: what the checks of the
// frame and the pass graph look at. Contract: README "Frame", "Ping-pong".
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orris/pack/shader_pack.h>
#include <orris/plan/schedule/program_uses.h>
#include <orris/plan/schedule/schedule.h>

namespace orris {

/// A buffer that a pass reads through a sampler, or touches through an image.
struct BufferUse {
  BufferName buffer;
  std::string name;  ///< as the program writes it: "gaux1"

  bool isColor(bool shadow) const;  ///< a colortex, or with `shadow` a shadowcolor
  bool isTarget() const { return isColor(false) || isColor(true); }
  bool inShadowMap() const { return isColor(true); }
};

/// One program at its place in the frame.
struct FramePass {
  enum class Kind { Compute, Fullscreen, Geometry, Shadow, Present, Copy };
  Kind kind = Kind::Fullscreen;
  std::string name;                        ///< of the program ("composite3"), or what is copied
  const ProgramSource* program = nullptr;  ///< nullptr: built into the host
  ProgramGroup group = ProgramGroup::Composite;
  bool drawn = true;   ///< false: a geometry program that is drawn only where a world has its things
  bool setup = false;  ///< runs once after load, not in each frame
  bool translucent = false;  ///< geometry drawn after the deferred programs
  std::vector<int> writes;   ///< colortex (shadow groups: shadowcolor) in slot order
  std::vector<int> mipmaps;
  /// Bit n: colortex n (shadowcolor n) is read from its alt side.
  std::uint32_t flipped = 0, shadowFlipped = 0;
  std::uint32_t flippedInGroup = 0;  ///< see Step
  ProgramUses names;                 ///< uniforms that its stages (or computes) reach from main
  /// Buffers that the pass really gets by those names: not colortex0 to 3 in geometry programs (the
  /// atlas), no names that a custom texture or image replaces.
  std::vector<BufferUse> uses;
  std::vector<std::string> unbound;  ///< of the names, those of colortex0 to 3 in geometry programs

  bool isGeometry() const { return kind == Kind::Geometry || kind == Kind::Shadow; }
  bool isShadowGroup() const;
  bool readsAlt(bool shadow, int buffer) const;
  bool writesAlt(int buffer) const;  ///< side a draw buffer is written to
};

/// All programs of the folder in frame order; geometry programs that the schedule leaves out stand
/// beside those of their half (opaque, translucent) or of the shadow pass.
std::vector<FramePass> framePasses(const ShaderPack& pack, const Schedule& schedule);

}  // namespace orris
