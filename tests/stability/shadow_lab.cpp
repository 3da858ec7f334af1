#include "shadow_lab.h"

#include <fmt/format.h>

#include <cmath>

#include "lab.h"
#include <orris/plan/frame/celestial.h>

namespace orris::test {
namespace {

constexpr const char* kWorld = R"({{
  "size": [64, 32, 64],
  "blocks": [{{"box": "stone", "min": [0, 0, 0], "max": [63, 1, 63]}}{}],
  "cameras": [{{"name": "eye", "position": [{}, {}, {}], "yaw": 90, "pitch": 30}}],
  "environment": {{"time": {}}}
}})";

constexpr const char* kProbe = R"(#version 430 compatibility
#include "/settings.glsl"
#include "/include/uniforms.glsl"
#include "/include/brdf/direct.glsl"
#include "/include/sky/sky.glsl"
#include "/include/shadow/shadow.glsl"
/* RENDERTARGETS: 0 */
layout(location = 0) out vec4 result;

float lit(vec3 world, vec3 normal) {{
    return light_visibility(world - cameraPosition, normal, light_direction(), shadow_radius, 1.0);
}}
{0}
vec4 test_probe(ivec2 pixel) {{ return {1}; }}
void main() {{ result = test_probe(ivec2(gl_FragCoord.xy)); }}
)";

std::string worldOf(const ShadowSetup& setup) {
  if (setup.world.empty())
    return fmt::format(kWorld, setup.blocks.empty() ? "" : ", " + setup.blocks, kShadowEye.x,
                       kShadowEye.y, kShadowEye.z, timeOfSun(setup.sun));
  std::string text = setup.world;
  edit(text, R"("time": 700)", fmt::format(R"("time": {})", timeOfSun(setup.sun)));
  return text;
}

}  // namespace

int timeOfSun(double degrees) {
  constexpr int kDay = 24000, kDawn = -1400, kNoon = 6000;
  int best = kNoon;  // a morning begins before 0
  double least = 360;
  for (int time = kDawn; time <= kNoon; ++time) {
    const int ticks = (time + kDay) % kDay;
    const double angle = glm::degrees(std::acos(sunDirection(skyAngleOf(ticks), 0).y));
    if (std::abs(angle - degrees) >= least) continue;
    least = std::abs(angle - degrees);
    best = ticks;
  }
  return best;
}

SessionSetup ShadowLab::sessionOf(const ShadowSetup& setup) {
  SessionSetup session;
  session.world = worldOf(setup);
  session.width = setup.width;
  session.height = setup.height;
  session.options = setup.options;
  session.options.emplace("GI_METHOD", "NONE");
  session.options.emplace("sunPathRotation", "0.0");
  session.change = [setup](PackTexts& files) {
    for (const auto& [option, value] : setup.constants) setDefault(files, option, value);
    files["/deferred6.fsh"] = fmt::format(kProbe, setup.functions, setup.probe);
    edit(files["/include/buffers.glsl"], "colortex0Format = RGBA16F", "colortex0Format = RGBA32F");
    if (setup.change) setup.change(files);
  };
  return session;
}

void ShadowLab::draw(int frames) {
  pack_.renderFrames(frames);
  image_ = pack_.dump("colortex0");
}

std::array<float, 4> ShadowLab::at(int x, int y) const {
  const float* texel = image_.at(x, image_.height - 1 - y);
  return {texel[0], texel[1], texel[2], texel[3]};
}

}  // namespace orris::test
