// Which bricks of 8^3 cells a step of the floodfill has to reckon, for FLOODFILL_STORAGE=IMAGE_3D: those
// whose blocks changed, and those whose light or whose neighbours' light the step before changed. Of
// all others the step would give what is there, bit for bit.
//
//   flood_list    r32ui, empty when a frame begins: row 0 the bricks, row 1 their number
//   flood_memory  r32ui, kept: row 0 when a brick's light last changed (step_stamp), row 1 a hash of
//                 its blocks
#if !defined INCLUDED_VOXEL_ACTIVE_BRICKS
#define INCLUDED_VOXEL_ACTIVE_BRICKS

#include "/include/voxel/volume.glsl"

const int flood_brick = 8;
const int flood_bricks = VOLUME / flood_brick;  // along an axis
const int flood_brick_count = flood_bricks * flood_bricks * flood_bricks;
const ivec2 flood_list_length = ivec2(0, 1);

// Of each program: the invocations of a group share a brick and have a column of 8 cells each.
const uint flood_groups = 64u;

bool step_in_frame() { return frameCounter % FLOODFILL_INTERVAL == 0; }

/// Steps are numbered from 1; frames between two steps have the number of the one before.
uint step_stamp() { return uint(frameCounter / FLOODFILL_INTERVAL) + 1u; }

ivec3 brick_place(int brick) {
    return ivec3(brick % flood_bricks, brick / (flood_bricks * flood_bricks),
                 brick / flood_bricks % flood_bricks);
}

int brick_index(ivec3 place) {
    return (place.y * flood_bricks + place.z) * flood_bricks + place.x;
}

/// Lowest cell of the column of invocation 0..63.
ivec3 brick_column(int brick, uint invocation) {
    return brick_place(brick) * flood_brick + ivec3(invocation & 7u, 0, invocation >> 3);
}

#endif
