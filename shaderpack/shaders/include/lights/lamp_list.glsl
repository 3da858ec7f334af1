// The shadow pass' part of the lamps: each quad of a lamp enters its block.
#if !defined INCLUDED_LIGHTS_LAMP_LIST
#define INCLUDED_LIGHTS_LAMP_LIST

#include "/include/blocks.glsl"
#include "/include/lights/lamps.glsl"
#include "/include/math/random.glsl"

layout(r32ui) uniform uimage3D lamp_cells;
layout(r32ui) uniform uimage2D lamp_tally;

int lamp_kind(int id) {
    if (id >= block_spot_lamp && is_lamp(id))
        return kind_spot + clamp((id - block_spot_lamp) / 10, 0, 5);
    return is_small_lamp(id) ? kind_ball : kind_cube;
}

/// `player`: middle of the block; `own`: its colour where its id lists none.
void list_lamp(vec3 player, int id, int level, vec3 own) {
    ivec3 cell = ivec3(floor(to_lamp_space(player)));
    if (level <= 0 || !in_lamp_volume(cell)) return;
    vec3 listed = is_lamp(id) ? lamp_color(id) : vec3(0.0);
    vec3 color = any(greaterThan(listed, vec3(0.0))) ? listed : own;
    uint lamp = pack_lamp(color, level, lamp_kind(id));

    // Faces of a block may differ in colour: the largest word wins, whatever their order, and the
    // checksum counts them all.
    uvec3 place = uvec3(cell);
    imageAtomicAdd(lamp_tally, lamp_checksum,
                   hash(uvec3(place.x | place.y << 16, place.z, lamp)).x);
    if (imageAtomicMax(lamp_cells, cell, lamp) != 0u) return;
    imageAtomicAdd(lamp_tally, cell.yz, 1u);
    imageAtomicAdd(lamp_tally, ivec2(lamp_volume, cell.z), 1u);
    imageAtomicAdd(lamp_tally, lamp_total, 1u);
}

#endif
