// Light from the lightmap: all there is without global illumination, and what is left outside of
// the voxel volume.
#if !defined INCLUDED_GI_AMBIENT
#define INCLUDED_GI_AMBIENT

#include "/include/sky/sky.glsl"

/// Ambient occlusion scales light that grows with the square of the levels.
vec2 occlude_light(vec2 light, float occlusion) { return light * sqrt(occlusion); }

/// Mean radiance over the hemisphere. `light` is block and sky level, 0..1.
vec3 ambient_radiance(vec2 light, vec3 normal) {
    vec3 block = vec3(1.0, 0.62, 0.32) * (EMISSION_STRENGTH * 0.06 * light.x * light.x);
    return block + sky_ambient(normal) * (light.y * light.y) + AMBIENT_MINIMUM;
}

#endif
