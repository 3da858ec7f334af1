// Shapes of blocks that fill a part of their cell, as the eighths of it that they fill: a bit each, x + 2 y
// + 4 z from the lower end of each axis. Stairs have theirs in an image, which the shadow pass fills quad by
// quad: voxel_sums from row 1 on, r32ui, 4 cells along x in a texel, empty when a frame begins.
#if !defined INCLUDED_VOXELS_OCTANTS
#define INCLUDED_VOXELS_OCTANTS

#include "/include/voxels/posts.glsl"
#include "/include/voxels/voxel.glsl"

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

const int octant_rows = (VOLUME * VOLUME * VOLUME_HEIGHT / 4 + sums_width - 1) / sums_width;
const int column_rows = (VOLUME * VOLUME + sums_width - 1) / sums_width;

/// Below them, for each column of cells: how high its highest opaque block reaches, of all that the shadow pass
/// draws, in the volume or above it; see stored_height. 0: there is none.
ivec2 height_texel(ivec2 column) {
    int texel = column.x + VOLUME * column.y;
    return ivec2(texel & (sums_width - 1), 1 + octant_rows + texel / sums_width);
}

/// And how deep the lowest floor lies that gets light of the sky: height_end - stored_height. 0: there is none.
ivec2 lit_floor_texel(ivec2 column) { return height_texel(column) + ivec2(0, column_rows); }

/// In a row behind them: 1 where a surface of water is in the volume.
const ivec2 lake_now = ivec2(0, 1 + octant_rows + 2 * column_rows);

/// Of a height in volume space, in eighths of a block; larger than 0, less than height_end.
uint stored_height(float y) { return uint(clamp(y * 8.0, -16000.0, 16000.0) + 16384.0); }
const uint height_end = 32768u;

float height_of_stored(uint stored) { return (float(stored) - 16384.0) / 8.0; }

int octants_shift(ivec3 cell) { return (cell.x & 3) * 8; }

/// Does the block fill a part of its cell only?
bool has_octants(int code) {
    return code == voxel_stairs || code == voxel_slab_bottom || code == voxel_slab_top;
}

#if defined HAS_OCTANT_WRITES
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

void note_lake() { imageStore(voxel_sums, lake_now, uvec4(1u)); }

/// A place on top of an opaque block, in volume space, and the sky's level there, 0..15.
void note_height(vec3 top, float level) {
    ivec2 column = ivec2(floor(top.xz));
    if (clamp(column, ivec2(0), volume_size.xz - 1) != column) return;
    imageAtomicMax(voxel_sums, height_texel(column), stored_height(top.y));
    if (level > 0.5) imageAtomicMax(voxel_sums, lit_floor_texel(column), height_end - stored_height(top.y));
}
#else
#if HAS_VOXEL_CHANGES
layout(r32ui) uniform readonly uimage2D voxel_sums;
#endif

/// The byte that stairs and posts have.
uint kept_shape(ivec3 cell) {
#if HAS_VOXEL_CHANGES
    return imageLoad(voxel_sums, octants_texel(cell)).r >> uint(octants_shift(cell)) & all_octants;
#else
    return 0u;
#endif
}

/// What a pane or a portal lies across, if it parts its cell: a stained pane, or a straight one of clear glass; else 0.
vec3 parted_axis(int code, ivec3 cell) {
    uint arms = 0u;
    if (is_pane(code)) arms = kept_shape(cell) & arms_of_pane;
    vec3 axis = vec3(arms == arms_along_z, 0.0, arms == arms_along_x);
    return is_partition(code) ? partition_axis(code) : axis;
}

/// Does light of the sky come to a place at the edge of the volume? Above all opaque blocks of its column, and above the
/// lowest of their floors that gets some: caves lie below that. Only the face cache keeps the heights.
bool sky_comes_to(vec3 position) {
#if HAS_FACE_CACHE
    ivec2 column = clamp(ivec2(floor(position.xz)), ivec2(0), volume_size.xz - 1);
    uint height = stored_height(position.y + 0.25);
    uint lit_floor = height_end - imageLoad(voxel_sums, lit_floor_texel(column)).r;
    return height > imageLoad(voxel_sums, height_texel(column)).r || height >= lit_floor;
#else
    return false;
#endif
}

#if HAS_FACE_CACHE
/// The height of the ground in a column of cells, below a place: of its highest block, or of the lowest floor that gets light of
/// the sky; above the place if there is none.
float ground_below(vec3 position, ivec2 column) {
    float highest = height_of_stored(imageLoad(voxel_sums, height_texel(column)).r);
    float lit_floor = height_of_stored(height_end - imageLoad(voxel_sums, lit_floor_texel(column)).r);
    return position.y > highest ? highest : lit_floor;
}
#endif

/// Of what stops light; none of what lets it pass, of leaves, of balls of lamps, and outside of the volume.
uint octants_of(int code, ivec3 cell) {
    bool full = is_opaque_voxel(code) && !is_ball(code) && !is_plate(code) && !has_planes(code);
    uint octants = full ? all_octants : 0u;
    octants = code == voxel_slab_bottom ? lower_octants : octants;
    octants = code == voxel_slab_top ? upper_octants : octants;
#if HAS_VOXEL_CHANGES
    octants = code == voxel_stairs ? kept_shape(cell) : octants;
#endif
    return octants;
}
#endif

#endif
