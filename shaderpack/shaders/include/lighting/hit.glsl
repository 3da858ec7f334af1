// What a ray finds at the block it hits.
#if !defined INCLUDED_LIGHTING_HIT
#define INCLUDED_LIGHTING_HIT

#include "/include/lighting/shadow.glsl"
#include "/include/lighting/sky.glsl"
#include "/include/math/sampling.glsl"
#include "/include/voxel/trace.glsl"

// A little off the face, more than depth rounds at the edge of the volume.
const float ray_offset = 0.02;

/// Radiance of a lamp where a ray hits it: small ones are balls.
vec3 lamp_light(Voxel v) {
    return lamp_radiance(v) * (v.code >= voxel_small_lamp ? small_lamp_boost : 1.0);
}

/// Where no sky light comes, the volume ends inside of a cave, not under the sky.
vec3 sky_beyond(vec3 direction, float sky) {
    return sky_radiance(direction) * smoothstep(0.0, 0.1, sky);
}

/// Sun or moon light that a hit reflects, without its albedo. `sky`: level where the ray began.
vec3 sun_at(Hit hit, vec3 light, float sky) {
    vec3 player = from_volume(hit.position);
    return light_irradiance() * (max(dot(hit.normal, light), 0.0) / pi) *
           light_visibility(player, hit.normal, light, 0, sky);
}

#endif
