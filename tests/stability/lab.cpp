#include "lab.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace orris::test {
namespace {

// Blocks may stand in every cell of the volume.
constexpr const char* kWorld = R"({{
  "size": [{0}, {0}, {0}], "blocks": [{1}], "events": [{2}],
  "cameras": [{{"name": "eye", "position": [{3}.5, {3}.5, {3}.5], "yaw": 180}}],
  "environment": {{"time": 18000}}
}})";

// Two passes before the propagation, as that must be the third to swap the target's sides: what the
// next frame starts from is the side that an odd number of writers ends on (Iris: FinalPassRenderer).
constexpr const char* kInject = R"(#version 330 compatibility
#include "/settings.glsl"
#include "/include/voxels/volume.glsl"
uniform sampler2D colortex4;
/* RENDERTARGETS: 4 */
layout(location = 0) out vec4 light;
void main() {{
    light = texelFetch(colortex4, ivec2(gl_FragCoord.xy), 0);
    ivec3 cell = atlas_cell(ivec2(gl_FragCoord.xy));
    if (frameCounter == {}) light = vec4({}, 1.0);
}}
)";

}  // namespace

const char* const kFullscreen =
    "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n";

void storeFullFloats(PackTexts& files) {
  edit(files["/include/buffers.glsl"], "colortex4Format = RGBA16F", "colortex4Format = RGBA32F");
}

void runOnlyTheVolume(PackTexts& files) {
  // The final program stays: it includes buffers.glsl.
  for (const char* program : {"deferred", "deferred1", "deferred2", "deferred3", "deferred4", "deferred5", "deferred6"})
    files["/shaders.properties"] += fmt::format("\nprogram.{}.enabled=false\n", program);
}

SessionSetup Lab::sessionOf(const LabSetup& setup) {
  SessionSetup session;
  session.world = fmt::format(kWorld, kLabSize, setup.blocks, setup.events, kLabSize / 2);
  session.width = session.height = setup.width;
  session.options = setup.options;
  session.options.emplace("VOXEL_SIZE", std::to_string(kLabSize));
  session.options.emplace("GI_METHOD", "FLOODFILL");
  session.options.emplace("FLOODFILL_INTERVAL", "1");
  session.options.emplace("FLOODFILL_STORAGE", "ATLAS_2D");
  session.change = [setup](PackTexts& files) {
    for (const auto& [option, value] : setup.constants) setDefault(files, option, value);
    runOnlyTheVolume(files);
    if (!setup.initial.empty())
      for (const std::string name : {"/begin", "/begin1"}) {
        files[name + ".fsh"] = fmt::format(kInject, setup.initialStep, setup.initial);
        files[name + ".vsh"] = kFullscreen;
      }
    if (setup.periodic) {
      edit(files["/include/floodfill/light_field.glsl"], "if (!in_volume(cell)) return vec3(0.0);",
           "cell = (cell + VOLUME) % VOLUME;");
      edit(files["/include/floodfill/propagation.glsl"], "in_volume(there) ?", "true ?");
    }
    if (setup.change) setup.change(files);
  };
  return session;
}

}  // namespace orris::test
