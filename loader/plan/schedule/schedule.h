// The frame as a value: which targets exist and which steps run in which order, decided once per
// pack, size and scene, before any GL call. Contract: README "Frame", "Ping-pong", "Clears".
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>
#include <orris/plan/schedule/geometry.h>
#include <orris/world/world.h>

namespace orris {

/// One colortex or shadowcolor.
struct TargetPlan {
  int index = 0;
  std::string format;  ///< name as in contract/formats.csv
  int width = 0, height = 0;
  bool clear = true;
  std::array<float, 4> clearColor{};
  bool clearToFog = false;  ///< colortex0 without ClearColor: fog colour, alpha 1
  bool needsAlt = false;    ///< some pass writes or flips it
  bool mipmaps = false;     ///< some pass reads it with mipmaps
  bool history = false;     ///< alt is copied into main at frame end
  bool operator==(const TargetPlan&) const = default;
};

struct Step {
  enum class Kind {
    ClearImages,  ///< custom images with clear=true
    ClearShadow,  ///< shadow depth to 1, shadowcolor to its colour
    ClearColor,   ///< colortex with clear=true, both sides; depth to 1
    Compute,      ///< the computes of `program`
    Fullscreen,
    Draw,             ///< `geometry` from the camera
    DrawShadow,       ///< `geometry` from the light
    ShadowVolumes,    ///< counts volumes in the stencil of depthtex0
    CopyShadowDepth,  ///< shadowtex0 -> shadowtex1
    ShadowMipmaps,
    SampleCenterDepth,
    CopyDepth,  ///< depthtex0 -> depthtex<index>
    Present,    ///< the final program, or a copy of colortex0
  };
  Kind kind = Kind::Fullscreen;
  std::string name;  ///< "composite3", "gbuffers_terrain_solid"
  int program = -1;  ///< index into ShaderPack::programs, -1: built-in
  ProgramGroup group = ProgramGroup::Composite;
  Geometry geometry = Geometry::Solid;
  int index = 0;                     ///< CopyDepth: destination
  std::vector<int> writes;           ///< colortex (shadow groups: shadowcolor) in slot order
  bool writesAlt(int buffer) const;  ///< side this step writes, see `flipped`
  std::vector<int> mipmaps;          ///< buffers whose read side gets mipmaps first
  /// Bit n: colortex n (shadowcolor n) is read from its alt side during this step.
  std::uint32_t flipped = 0, shadowFlipped = 0;
  /// Colortex that earlier programs of the same group flipped: a texture.* that replaces one of them
  /// ends there (buffers.csv "custom texture").
  std::uint32_t flippedInGroup = 0;
};

struct Schedule {
  int width = 0, height = 0;
  int shadowResolution = 0;  ///< 0: no shadow targets at all
  std::vector<TargetPlan> colortex, shadowcolor;
  bool shadowtex1 = false, depthtex1 = false, depthtex2 = false, noisetex = false;
  bool stencil = false;  ///< the depth textures have one, for shadow volumes
  bool sunVolumes = false, lampShadows = false;  ///< stenciltex0, stenciltex1 are read
  bool centerDepth = false;
  std::vector<Step> setup;  ///< once after load and resize
  std::vector<Step> frame;
  std::set<int> programs;  ///< indices of programs that must be compiled
  /// Side of each buffer that holds the last image at frame end.
  std::uint32_t finalFlipped = 0, finalShadowFlipped = 0;

  const TargetPlan* target(bool shadow, int index) const;
  /// Would the textures made for `other` serve this schedule?
  bool sameTargets(const Schedule& other) const;
};

/// What the world contains; programs that nothing needs are not scheduled.
struct SceneContents {
  bool solid = true, cutout = true, blockEntities = true, translucent = true;
  bool sky = true;
  bool endSky = false;          ///< that of the End in its place
  bool cloudPlane = true;       ///< the dimension has clouds, which a pack may switch on
  Clouds clouds = Clouds::Off;  ///< what the world asks for
  GeometrySet content = 0;      ///< kinds besides blocks, sky and clouds
  bool operator==(const SceneContents&) const = default;
};

/// Problems (draw buffers of unequal size, unknown formats, missing required feature) are
/// diagnostics; the schedule is usable only without errors.
Schedule buildSchedule(const ShaderPack& pack, int width, int height, const SceneContents& scene,
                       Diagnostics& diagnostics);

}  // namespace orris
