// Directives in shader text: RENDERTARGETS / DRAWBUFFERS comments and const lines.
// Contract: constants.csv.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/glsl/tokens/token.h>
#include <orris/pack/programs/const_line.h>

namespace orris {

/// colortex0 to colortex31. Iris: IrisLimits.MAX_COLOR_BUFFERS. One bit each in the masks of a Step.
inline constexpr int kColorTargets = 32;
inline constexpr int kShadowColorTargets = 8;

/// Settings of one colortex or shadowcolor.
struct TargetSettings {
  std::string format = "RGBA";
  bool clear = true;
  std::optional<std::array<float, 4>> clearColor;
  bool mipmap = false;   ///< shadowcolor only
  bool nearest = false;  ///< shadowcolor only
};

/// Settings of one shadowtex.
struct ShadowDepthSettings {
  bool hardwareFiltering = false;
  bool mipmap = false;
  bool nearest = false;
};

/// What all programs together say about the frame.
struct PackDirectives {
  std::map<int, TargetSettings> colortex;
  std::map<int, TargetSettings> shadowcolor;
  std::array<ShadowDepthSettings, 2> shadowtex;
  int shadowMapResolution = 1024;
  float shadowDistance = 160;
  float shadowDistanceRenderMul = -1;
  float entityShadowDistanceMul = 1;
  float shadowIntervalSize = 2;
  std::optional<float> shadowMapFov;
  float shadowNearPlane = 0.05f;
  float shadowFarPlane = 256;
  float voxelDistance = 0;
  float sunPathRotation = 0;
  float ambientOcclusionLevel = 1;
  int noiseTextureResolution = 256;
  float wetnessHalflife = 600, drynessHalflife = 200;
  float eyeBrightnessHalflife = 10, centerDepthHalflife = 1;
};

/// What one fragment (or compute) stage says about its own program.
struct ProgramDirectives {
  std::optional<std::vector<int>> drawBuffers;  ///< nullopt: no directive
  SourceLocation drawBuffersAt;
  std::set<int> mipmaps;  ///< colortex (or shadowcolor) read with mipmaps
  std::optional<std::array<int, 3>> workGroups;
  std::optional<std::array<float, 2>> workGroupsRender;
};

/// Reads the directives of one preprocessed fsh or csh; the last one of a kind wins. `targets` is the
/// number of buffers that the program can draw to; a higher index is an error.
ProgramDirectives readProgramDirectives(const TokenStream& stream, int targets,
                                        Diagnostics& diagnostics);
/// Adds what the const lines of one preprocessed fsh say to `directives` (call in the contract's scan
/// order). `sites` are those of its token stream.
void readPackDirectives(const std::vector<ConstLine>& lines, const std::vector<IncludeSite>& sites,
                        PackDirectives& directives, Diagnostics& diagnostics);

/// Names of the const lines that readPackDirectives knows, but for those of single targets
/// (colortexNFormat, ...).
std::vector<std::string_view> packDirectiveNames();

}  // namespace orris
