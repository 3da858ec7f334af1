// The inside of a block of leaves, which is hollow: light passes its sides by their holes, and they let through
// and reflect what falls on them. With the face cache light_of(cell, face) belongs to the program: B of a face, and
// its number of updates.
#if !defined INCLUDED_GI_LEAVES
#define INCLUDED_GI_LEAVES

#include "/include/gi/hit.glsl"
#if HAS_FACE_CACHE
#include "/include/face_cache/face_cache.glsl"
#endif

/// What the side by which a ray leaves the block of leaves that it begins in shows of itself from inside. `sky`: level where the ray began.
vec3 light_of_leaves(vec3 origin, vec3 direction, vec3 light, float sky) {
    Hit side = side_of_leaves(origin, direction);
    vec3 arriving = sun_at(side, light, sky);
#if HAS_FACE_CACHE
    // Towards a full block it has no face of its own.
    vec4 cached = light_of(side.cell, face_of(side.normal));
    if (cached.a == 0.0 || is_opaque_voxel(voxel_at(side.cell + ivec3(side.normal)).code)) return vec3(0.0);
    // What the inside reflects adds up to a geometric series.
    vec3 stopped = (1.0 - open_share(voxel_solid, face_of(side.normal))) * side.voxel.color;
    vec3 passed = float(!in_leaf_hole(side)) * min(side.voxel.color, 1.0 - side.voxel.color);
    return passed * (arriving + cached.rgb) / (1.0 - stopped);
#else
    return side.voxel.color * arriving;
#endif
}

#endif
