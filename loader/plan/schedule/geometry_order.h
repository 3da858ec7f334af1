// What geometry is drawn in which order, in the frame and in the shadow map. Iris: WorldRenderingPhase, ShadowRenderer.
#pragma once

#include <string_view>

#include <orris/plan/schedule/schedule.h>

namespace orris {

/// One draw of a group: the program that a pack may have for it, and what of the scene it needs.
struct GeometryPass {
  std::string_view program;
  Geometry geometry;
  bool SceneContents::*needed = nullptr;  ///< nullptr: content, whose kind says so
};

namespace geometry_order {

/// Content, drawn by the program that its table names.
constexpr GeometryPass content(Geometry geometry) { return {"", geometry}; }
inline constexpr GeometryPass kSky[] = {
    {"gbuffers_skybasic", Geometry::Sky, &SceneContents::sky},
    {"gbuffers_skybasic", Geometry::Stars, &SceneContents::sky},
    {"gbuffers_skytextured", Geometry::SunMoon, &SceneContents::sky},
    {"gbuffers_skytextured", Geometry::EndSky, &SceneContents::endSky}};
// Entities that blend and particles are before or after the deferred programs, as the pack wants.
inline constexpr GeometryPass kOpaque[] = {
    {"gbuffers_terrain_solid", Geometry::Solid, &SceneContents::solid},
    {"gbuffers_terrain_cutout", Geometry::Cutout, &SceneContents::cutout},
    content(Geometry::Leash),
    content(Geometry::Entities),
    content(Geometry::EntitiesTranslucent),
    content(Geometry::Eyes),
    content(Geometry::Glint),
    content(Geometry::Lightning),
    {"gbuffers_block", Geometry::BlockEntity, &SceneContents::blockEntities},
    content(Geometry::BlockText),
    content(Geometry::BeamCore),
    content(Geometry::BeamGlow),
    content(Geometry::Cracks),
    content(Geometry::Outline),
    content(Geometry::Particles),
    content(Geometry::ParticlesTranslucent)};
inline constexpr GeometryPass kHand[] = {content(Geometry::Hand), content(Geometry::HandGlint)};
inline constexpr GeometryPass kTranslucent[] = {
    content(Geometry::EntitiesTranslucent),
    {"gbuffers_water", Geometry::Translucent, &SceneContents::translucent},
    content(Geometry::Particles),
    content(Geometry::ParticlesTranslucent),
    {"gbuffers_clouds", Geometry::CloudsFast, &SceneContents::cloudPlane},
    {"gbuffers_clouds", Geometry::CloudsFancy, &SceneContents::cloudPlane},
    content(Geometry::Rain),
    content(Geometry::Snow),
    content(Geometry::Border),
    content(Geometry::HandTranslucent)};
inline constexpr GeometryPass kShadowOpaque[] = {
    {"shadow_solid", Geometry::Solid, &SceneContents::solid},
    {"shadow_cutout", Geometry::Cutout, &SceneContents::cutout},
    content(Geometry::Leash),
    content(Geometry::Entities),
    content(Geometry::EntitiesTranslucent),
    content(Geometry::PlayerBody),
    content(Geometry::Lightning),
    {"shadow_block", Geometry::BlockEntity, &SceneContents::blockEntities},
    content(Geometry::BlockText),
    content(Geometry::BeamCore)};
inline constexpr GeometryPass kShadowTranslucent[] = {
    {"shadow_water", Geometry::Translucent, &SceneContents::translucent}};

}  // namespace geometry_order
}  // namespace orris
