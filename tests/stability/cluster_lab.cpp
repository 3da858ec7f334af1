#include "cluster_lab.h"

#include <fmt/format.h>

#include "lab.h"

namespace orris::test {
namespace {

constexpr const char* kWorld = R"({
  "size": [8, 8, 8], "blocks": [{"block": "stone", "at": [0, 0, 0]}],
  "cameras": [{"name": "eye", "position": [4.3, 4.6, 4.2], "yaw": 150, "pitch": 20}],
  "environment": {"time": 18000}
})";

constexpr const char* kRandom = R"(
vec3 random(int n) {{
    return vec3(hash(uvec3(uint(n), uint(frameCounter), 7u)) >> 8u) / 16777216.0;
}}
)";

// In place of the program that makes the table of the lamps that the shadow pass found.
constexpr const char* kTable = R"(#version 430 compatibility
#include "/settings.glsl"
#include "/include/lights/changes.glsl"
#include "/include/lights/grid_rest.glsl"
#include "/include/lights/lamp_light.glsl"
#include "/include/math/random.glsl"
layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(1, 1, 1);
layout(rgba32f) uniform writeonly image2D light_table;
{0}
Light test_light(int i) {{ return {1}; }}
void main() {{
    clear_rests(int(gl_LocalInvocationID.x), 64);
    for (int i = int(gl_LocalInvocationID.x); i < {2}; i += 64) {{
        Light light = test_light(i);
        imageStore(light_table, table_texel(uint(i)),
                   vec4(to_lamp_space(light.place), light.inverse));
        imageStore(light_table, table_texel(uint(i)) + ivec2(1, 0),
                   vec4(light.intensity, light.radius));
    }}
    if (gl_LocalInvocationID.x == 0u) {{
        imageStore(lamp_tally, lamp_total, uvec4({2}u));
        imageStore(lamp_tally, lamp_checksum, uvec4(uint(frameCounter) + 1u));
    }}
}}
)";

constexpr const char* kProbe = R"(#version 430 compatibility
#include "/settings.glsl"
#include "/include/uniforms.glsl"
#include "/include/lights/lit_by_lamps.glsl"
#include "/include/math/random.glsl"
/* RENDERTARGETS: 0 */
layout(location = 0) out vec4 result;
{0}

// A point that is seen, view space: u.xy on the screen, u.z its distance, 1/16 to 70.
vec3 seen(vec3 u) {{
    float distance_along = exp2(mix(-4.0, 6.13, u.z));
    vec2 slopes = (u.xy * 2.0 - 1.0) / vec2(gbufferProjection[0][0], gbufferProjection[1][1]);
    return vec3(slopes * distance_along, -distance_along);
}}

// A point: the light of its cluster's list, that of all lights, and whether these are the same bits.
vec4 compare(vec3 view) {{
    vec3 position = to_lamp_space((gbufferModelViewInverse * vec4(view, 1.0)).xyz);
    vec3 normal = normalize(random(int(gl_FragCoord.x) + 997) - 0.5);
    vec3 listed = cluster_irradiance(cluster_of(view), position, normal, 1.0);
    vec3 all = table_irradiance(position, normal, 1.0);
    return vec4(listed.r, all.r, float(listed == all), 0.0);
}}

{2}
vec4 test_probe(ivec2 pixel) {{ return {1}; }}
void main() {{ result = test_probe(ivec2(gl_FragCoord.xy)); }}
)";

}  // namespace

LightState stateOf(PackSession& pack) {
  const ImageF state = pack.dump("light_state");
  const auto at = [&state](int texel) { return static_cast<int>(state.at(texel, 0)[0]); };
  return {at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
}

SessionSetup ClusterLab::sessionOf(const ClusterSetup& setup) {
  SessionSetup session;
  session.world = kWorld;
  session.width = session.height = setup.width;
  session.options = setup.options;
  session.options.emplace("LIGHT_METHOD", "CLUSTERED");
  session.options.emplace("GI_METHOD", "NONE");
  session.options.emplace("SHADOW_METHOD", "NONE");
  session.options.emplace("LIGHT_CAPACITY", "1024");
  session.change = [setup](PackTexts& files) {
    const std::string random = fmt::format(kRandom);
    files["/shadowcomp3.csh"] = fmt::format(kTable, random, setup.light, setup.lights);
    files["/deferred6.fsh"] = fmt::format(kProbe, random, setup.probe, setup.functions);
    edit(files["/include/buffers.glsl"], "colortex0Format = RGBA16F", "colortex0Format = RGBA32F");
    if (setup.change) setup.change(files);
  };
  return session;
}

std::array<float, 4> ClusterLab::probe(int x, int y) {
  const ImageF image = pack_.dump("colortex0");
  const float* texel = image.at(x, image.height - 1 - y);
  return {texel[0], texel[1], texel[2], texel[3]};
}

}  // namespace orris::test
