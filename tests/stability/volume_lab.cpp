#include "volume_lab.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "caster_rays.h"
#include <orris/world/files/world_json.h>

namespace orris::test {
namespace {

// The floor is two blocks thick, so that its underside makes no edge that is seen.
constexpr const char* kWorld = R"({{
  "size": [{0}, {1}, {2}],
  "blocks": [{{"box": "stone", "min": [0, 0, 0], "max": [{3}, 1, {4}]}}, {5}],
  "cameras": [{{"name": "eye", "position": [8.5, 8.5, 8.5]}}],
  "environment": {{"time": {6}}}
}})";

std::string worldOf(const VolumeSetup& setup) {
  return fmt::format(kWorld, setup.box.x, setup.box.y, setup.box.z, setup.box.x - 1,
                     setup.box.z - 1, setup.blocks, setup.time);
}

OptionValues optionsOf(const VolumeSetup& setup) {
  OptionValues options = setup.options;
  options["GI_METHOD"] = "NONE";
  options.emplace("SHADOW_VIEW", "true");
  options["SHADOW_METHOD"] = setup.method;
  options["sunPathRotation"] = setup.sunPathRotation;
  return options;
}

}  // namespace

VolumeLab::VolumeLab(const VolumeSetup& setup)
    : setup_(setup),
      world_(worldOf(setup)),
      session_(SessionSetup{world_, optionsOf(setup), setup.size, setup.size, {}}) {}

void VolumeLab::look(glm::dvec3 from, glm::dvec3 to, float fov) {
  session_.look(from, to);
  Camera camera = session_.session().camera();
  camera.fov = fov;
  session_.session().setCamera(camera);
}

ImageF VolumeLab::drawn() {
  session_.renderFrames(1);
  return session_.dump("colortex0");
}

int VolumeLab::count(int x, int y) {
  return int(std::lround(session_.dump("stenciltex0").at(x, y)[0]));
}

ReferenceScene VolumeLab::referenceScene() const {
  Diagnostics diagnostics;
  auto world = parseWorldJson({.text = world_, .file = "world.json"}, diagnostics);
  auto& session = const_cast<PackSession&>(session_).session();
  return buildReferenceScene(std::move(*world), session.renderer().pack(), session.camera(),
                             setup_.size, setup_.size, diagnostics);
}

CasterSet VolumeLab::casters() const {
  const SceneData& scene = const_cast<PackSession&>(session_).session().scene();
  return castersOf(scene.mesh, scene.atlas);
}

ImageF VolumeLab::reference() const {
  const ReferenceScene scene = referenceScene();
  const CasterRays rays(casters());
  return shadowMask(scene.scene, scene.camera, rays.stopping(), glm::dvec4(scene.shadowLight, 0));
}

ImageF VolumeLab::referenceOfLamp(const glm::ivec3& cell) const {
  constexpr double kEverywhere = 1e6;
  const ReferenceScene scene = referenceScene();
  const CasterRays rays(castersOfLamp(casters(), cell, kEverywhere));
  return shadowMask(scene.scene, scene.camera, rays.stopping(), glm::dvec4(glm::dvec3(cell) + 0.5, 1));
}

MaskDifference VolumeLab::difference() {
  Diagnostics diagnostics;
  const auto result = compareMasks(drawn(), reference(), diagnostics);
  EXPECT_TRUE(result);
  return result.value_or(MaskDifference{});
}

}  // namespace orris::test
