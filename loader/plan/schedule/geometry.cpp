#include <orris/plan/schedule/geometry.h>

#include <algorithm>

namespace orris {
namespace {

using G = Geometry;
using B = DefaultBlend;

constexpr int kEntities = 11, kBlockEntities = 12, kDestroy = 13, kOutline = 14, kHandSolid = 16,
              kParticleStage = 19, kRainSnow = 21, kWorldBorder = 22, kHandTranslucent = 23;
constexpr float kNoTest = -1, kTenth = 0.1f, kNotZero = 0.0001f;

constexpr ContentKind kKinds[] = {
    {G::Leash, "gbuffers_basic", "shadow", kEntities, Sheet::White, B::Off, kNoTest, true, false},
    {G::Entities, "gbuffers_entities", "shadow_entities", kEntities, Sheet::Content, B::Off, kTenth,
     true, false},
    {G::EntitiesTranslucent, "gbuffers_entities_translucent", "shadow_entities", kEntities,
     Sheet::Content, B::Translucent, kTenth, true, false},
    {G::Eyes, "gbuffers_spidereyes", "", kEntities, Sheet::Content, B::Eyes, kNotZero, false, true},
    {G::Glint, "gbuffers_armor_glint", "", kEntities, Sheet::Glint, B::Glint, kNotZero, false,
     false},
    {G::Lightning, "gbuffers_lightning", "shadow_lightning", kEntities, Sheet::White, B::Lightning,
     kNoTest, true, false},
    {G::BlockText, "gbuffers_block_translucent", "shadow_block", kBlockEntities, Sheet::White,
     B::Translucent, kTenth, true, true},
    {G::BeamCore, "gbuffers_beaconbeam", "shadow_entities", kBlockEntities, Sheet::Beam, B::Off,
     kNoTest, true, true},
    {G::BeamGlow, "gbuffers_beaconbeam", "", kBlockEntities, Sheet::Beam, B::Translucent, kNoTest,
     false, true},
    {G::Cracks, "gbuffers_damagedblock", "", kDestroy, Sheet::Content, B::Cracks, kTenth, false,
     true},
    {G::Outline, "gbuffers_line", "", kOutline, Sheet::White, B::Translucent, kNoTest, true, false},
    {G::Particles, "gbuffers_particles", "", kParticleStage, Sheet::Content, B::Off, kTenth, true,
     false},
    {G::ParticlesTranslucent, "gbuffers_particles_translucent", "", kParticleStage, Sheet::Content,
     B::Translucent, kTenth, true, false},
    {G::Hand, "gbuffers_hand", "", kHandSolid, Sheet::Content, B::Off, kTenth, true, true},
    {G::HandGlint, "gbuffers_armor_glint", "", kHandSolid, Sheet::Glint, B::Glint, kNotZero, false,
     false},
    {G::HandTranslucent, "gbuffers_hand_water", "", kHandTranslucent, Sheet::Content,
     B::Translucent, kTenth, true, true},
    {G::Rain, "gbuffers_weather", "", kRainSnow, Sheet::Rain, B::Translucent, kTenth, false, false},
    {G::Snow, "gbuffers_weather", "", kRainSnow, Sheet::Snow, B::Translucent, kTenth, false, false},
    {G::Border, "gbuffers_textured", "", kWorldBorder, Sheet::Border, B::Additive, kNotZero, false,
     false},
    {G::PlayerBody, "", "shadow_entities", kEntities, Sheet::Content, B::Off, kTenth, true, false},
};

}  // namespace

bool isSky(Geometry geometry) {
  return geometry == Geometry::Sky || geometry == Geometry::Stars || geometry == Geometry::SunMoon ||
         geometry == Geometry::EndSky;
}

bool isClouds(Geometry geometry) {
  return geometry == Geometry::CloudsFast || geometry == Geometry::CloudsFancy;
}

bool isHand(Geometry geometry) {
  return geometry == Geometry::Hand || geometry == Geometry::HandGlint ||
         geometry == Geometry::HandTranslucent;
}

bool isGlint(Geometry geometry) {
  return geometry == Geometry::Glint || geometry == Geometry::HandGlint;
}

std::span<const ContentKind> contentKinds() { return kKinds; }

GeometrySet contentSet() {
  GeometrySet set = 0;
  for (const ContentKind& kind : kKinds) set |= bitOf(kind.geometry);
  return set;
}

const ContentKind* findContentKind(Geometry geometry) {
  const auto* found = std::ranges::find(kKinds, geometry, &ContentKind::geometry);
  return found == std::end(kKinds) ? nullptr : found;
}

}  // namespace orris
