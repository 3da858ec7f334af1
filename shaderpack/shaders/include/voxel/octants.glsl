// Shapes of blocks that fill a part of their cell, as the eighths of it that they fill: a bit each, x + 2 y
// + 4 z from the lower end of each axis. Stairs have theirs in an image, which the shadow pass fills quad by
// quad: voxel_sums from row 1 on, r32ui, 4 cells along x in a texel, empty when a frame begins.
#if !defined INCLUDED_VOXEL_OCTANTS
#define INCLUDED_VOXEL_OCTANTS

#include "/include/voxel/posts.glsl"
#include "/include/voxel/voxel.glsl"

// Texels in a row of voxel_sums, which begins with one for each brick; shaders.properties repeats it.
#if VOLUME == 256
const int sums_width = 16384;
#else
const int sums_width = 4096;
#endif

const uint all_octants = 255u;
const uint lower_octants = 0x33u;
const uint upper_octants = 0xCCu;

/// shaders.properties repeats how many rows there are.
ivec2 octants_texel(ivec3 cell) {
    int texel = (cell.x >> 2) + VOLUME / 4 * (cell.y + VOLUME_HEIGHT * cell.z);
    return ivec2(texel & (sums_width - 1), 1 + texel / sums_width);
}

int octants_shift(ivec3 cell) { return (cell.x & 3) * 8; }

/// Does the block fill a part of its cell only?
bool has_octants(int code) {
    return code == voxel_stairs || code == voxel_slab_bottom || code == voxel_slab_top;
}

#if defined MAKES_OCTANTS
/// The octants behind a quad that reaches from `low` to `high`, as seen from the middle of its block.
uint octants_behind(vec3 low, vec3 high, vec3 normal) {
    const float on_plane = 1.0 / 32.0;
    bvec3 lower = lessThan(low - 0.25 * normal, vec3(-on_plane));
    bvec3 upper = greaterThan(high - 0.25 * normal, vec3(on_plane));
    uint x = (lower.x ? 0x55u : 0u) | (upper.x ? 0xAAu : 0u);
    uint y = (lower.y ? lower_octants : 0u) | (upper.y ? upper_octants : 0u);
    uint z = (lower.z ? 0x0Fu : 0u) | (upper.z ? 0xF0u : 0u);
    return x & y & z;
}

void add_octants(ivec3 cell, uint octants) {
    imageAtomicOr(voxel_sums, octants_texel(cell), octants << uint(octants_shift(cell)));
}
#else
#if NOTICE_CHANGES
layout(r32ui) uniform readonly uimage2D voxel_sums;
#endif

/// The byte that stairs and posts have.
uint kept_shape(ivec3 cell) {
#if NOTICE_CHANGES
    return imageLoad(voxel_sums, octants_texel(cell)).r >> uint(octants_shift(cell)) & all_octants;
#else
    return 0u;
#endif
}

/// Of what stops light; none of what lets it pass, of balls of lamps, and outside of the volume.
uint octants_of(int code, ivec3 cell) {
    bool full = is_opaque_voxel(code) && code < voxel_small_lamp && !is_plate(code);
    uint octants = full ? all_octants : 0u;
    octants = code == voxel_slab_bottom ? lower_octants : octants;
    octants = code == voxel_slab_top ? upper_octants : octants;
#if NOTICE_CHANGES
    octants = code == voxel_stairs ? kept_shape(cell) : octants;
#endif
    return octants;
}
#endif

#endif
