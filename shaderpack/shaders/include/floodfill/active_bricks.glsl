// Which bricks a step of the floodfill has to compute, for FLOODFILL_STORAGE=IMAGE_3D: those whose blocks
// changed, those whose light the step before changed, and their neighbours. Of all others the step
// would give what is there.
//
//   flood_list    r32ui, empty when a frame begins: row 0 the bricks, row 2 those whose cells are made ready
//                 for it, row 1 their numbers; row 3, by brick: were cells stepped that have yet to be tinted?
//   flood_state   r32ui, empty when a frame begins, for the host: how many of them, of how many
//   flood_memory  r32ui, kept: when a brick's light last changed (step_stamp)
#if !defined INCLUDED_FLOODFILL_ACTIVE_BRICKS
#define INCLUDED_FLOODFILL_ACTIVE_BRICKS

#include "/include/voxels/changes.glsl"
#include "/include/floodfill/flood_image.glsl"

const int step_list = 0;
const int ready_list = 2;
const int filter_flags = 3;
const ivec2 step_list_length = ivec2(0, 1);
const ivec2 ready_list_length = ivec2(1, 1);

bool step_in_frame() { return frameCounter % FLOODFILL_INTERVAL == 0; }

/// Lowest place of the column of 8 cells that invocation 0..63 has in a brick.
ivec3 brick_column(int brick, uint invocation) {
    return brick_place(brick) * brick_size + ivec3(invocation & 7u, 0, invocation >> 3);
}

#endif
