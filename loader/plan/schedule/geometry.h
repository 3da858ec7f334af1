// What geometry steps draw, and how the game draws each kind of content: one table.
// Contract: programs.csv. Iris: ShaderKey, IrisPipelines, WorldRenderingPhase.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace orris {

/// Blocks, sky and clouds first; what follows is content (world/content/content.h), in draw order.
enum class Geometry {
  Sky,
  Stars,
  SunMoon,
  EndSky,
  Solid,
  Cutout,
  BlockEntity,
  Translucent,
  CloudsFast,
  CloudsFancy,
  Leash,
  Entities,
  EntitiesTranslucent,
  Eyes,
  Glint,
  Lightning,
  BlockText,
  BeamCore,
  BeamGlow,
  Cracks,
  Outline,
  Particles,
  ParticlesTranslucent,
  Hand,
  HandGlint,
  HandTranslucent,
  Rain,
  Snow,
  Border,
  PlayerBody,  ///< only its shadow is drawn
};
bool isSky(Geometry geometry);
bool isClouds(Geometry geometry);
bool isHand(Geometry geometry);
bool isGlint(Geometry geometry);

/// Kinds as bits.
using GeometrySet = std::uint32_t;
GeometrySet contentSet();  ///< all but blocks, sky and clouds
constexpr GeometrySet bitOf(Geometry geometry) { return 1u << static_cast<unsigned>(geometry); }

/// The texture of unit 0. Those after White repeat.
enum class Sheet { Blocks, Content, White, Glint, Rain, Snow, Beam, Border };

/// Blending where the pack says nothing.
enum class DefaultBlend { Off, Translucent, Additive, Lightning, Eyes, Glint, Cracks };

struct ContentKind {
  Geometry geometry;
  std::string_view program;        ///< "" for what only casts a shadow
  std::string_view shadowProgram;  ///< "" for what casts none
  int renderStage;                 ///< MC_RENDER_STAGE_*
  Sheet sheet;
  DefaultBlend blend;
  float alphaReference;  ///< of the default test "greater"; negative: there is none
  bool writesDepth, culled;
};

std::span<const ContentKind> contentKinds();
/// nullptr for blocks, sky and clouds.
const ContentKind* findContentKind(Geometry geometry);

}  // namespace orris
