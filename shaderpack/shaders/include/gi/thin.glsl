// Plants and leaves are lit from both sides. The cache has for a side of leaves what falls on either, the inside as a share of
// the outside.
#if !defined INCLUDED_GI_THIN
#define INCLUDED_GI_THIN

#include "/include/math/random.glsl"

/// Of the light on the back of a thin surface, what shows as a share of what the front would
/// reflect: it passes as much as it reflects, at most what is left of it.
vec3 passed_share(vec3 albedo) {
    return min(vec3(1.0), (1.0 - albedo) / max(albedo, vec3(1e-3)));
}

/// Turns the normal of half of the rays from a thin surface round. Returns what counts, before its albedo, for the light that
/// comes from there.
vec3 choose_side(bool thin, vec3 albedo, inout vec3 normal) {
    if (!thin) return vec3(1.0);
    if (next_random().x < 0.5) return vec3(2.0);
    normal = -normal;
    return 2.0 * passed_share(albedo);
}

#endif
