// The shadow pass' part of noticing changes: each quad of a block enters itself into its brick's checksum.
#if !defined INCLUDED_VOXELS_CHECKSUM
#define INCLUDED_VOXELS_CHECKSUM

#include "/include/voxels/changes.glsl"
#include "/include/math/random.glsl"

layout(r32ui) uniform uimage2D voxel_sums;
/// Checksums are sums, so the order of the quads does not matter. `look`: what else the quad shows.
void add_to_brick(ivec3 cell, int face, int code, vec2 look) {
    uvec3 place = uvec3(volume_origin() + cell) * uvec3(73856093u, 19349663u, 83492791u);
    uint what = uint(face * 256 + code);
    uint sum = hash(uvec3(place.x ^ place.y ^ place.z, what, floatBitsToUint(look.x + 3.0 * look.y))).x;
    imageAtomicAdd(voxel_sums, ivec2(brick_index(store_cell(cell) / brick_size), 0), sum);
}

#endif
