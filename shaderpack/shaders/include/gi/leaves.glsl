// The inside of a block of leaves, which is hollow: light passes its sides by their holes, and they let through
// and reflect what falls on them. With the face cache light_of(cell, face) belongs to the program: B of a face, and
// its number of updates.
#if !defined INCLUDED_GI_LEAVES
#define INCLUDED_GI_LEAVES

#include "/include/gi/hit.glsl"
#if HAS_FACE_CACHE
#include "/include/face_cache/face_cache.glsl"
#endif

/// What the side by which a ray leaves the block of leaves that it begins in shows inside of the light on it; 0 towards a
/// full block, where it has no face of its own.
vec3 passed_by_side(Hit side) {
#if HAS_FACE_CACHE
    if (is_opaque_voxel(voxel_at(side.cell + ivec3(side.normal)).code)) return vec3(0.0);
    // What the inside reflects adds up to a geometric series.
    vec3 stopped = (1.0 - open_share(voxel_solid, face_of(side.normal))) * side.voxel.color;
    return float(!in_leaf_hole(side)) * min(side.voxel.color, 1.0 - side.voxel.color) / (1.0 - stopped);
#else
    return side.voxel.color;
#endif
}

/// Whether rays from there begin in leaves: 1 or 0.
vec3 within_leaves(vec3 origin) { return vec3(begins_in_leaves(origin)); }

/// Sunlight along a ray: what of it counts on the hit is `reflected`, and on the side of the leaves that the ray begins in,
/// with the light that the cache has of that, `leaves`; 0: it begins in none. `sky`: level where it began.
vec3 sun_along(Hit hit, vec3 reflected, vec3 leaves, vec3 origin, vec3 direction, vec3 light, float sky) {
    vec3 radiance = vec3(0.0);
    // One call at one place: some drivers compile each.
    for (int i = int(leaves == vec3(0.0)); i < 1 + int(hit.found); ++i) {
        Hit lit = hit;
        vec3 share = reflected;
        if (i == 0) {
            lit = side_of_leaves(origin, direction);
            share = leaves * passed_by_side(lit);
#if HAS_FACE_CACHE
            radiance += share * light_of(lit.cell, face_of(lit.normal)).rgb;
#endif
        }
        radiance += share * sun_at(lit, light, sky);
    }
    return radiance;
}

#endif
