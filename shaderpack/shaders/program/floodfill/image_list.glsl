// Lists for this frame the bricks whose cells floodfill/image_cells has to make ready, and those that the step has
// to compute.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(8, 1, 1);

#include "/include/floodfill/active_bricks.glsl"

layout(r32ui) uniform uimage2D flood_list;
layout(r32ui) uniform readonly uimage2D flood_memory;
layout(r32ui) uniform readonly uimage2D voxel_memory;

bool edited_since_step(int brick) {
    return changed_within(imageLoad(voxel_memory, ivec2(brick, 1)).r, FLOODFILL_INTERVAL);
}

bool light_changed(int brick) {
    return imageLoad(flood_memory, ivec2(brick, 0)).r + 1u == step_stamp();
}

/// What asks for a step of a brick, in it or beside it, and for its cells to be made ready.
struct Restless {
    bool light;
    bool blocks;
    bool own_blocks;  // or those above or below, of which cells know something, too
};

/// Those at the edge of the volume count as neighbours.
Restless restless_about(int brick) {
    ivec3 place = brick_place(brick);
    Restless found = Restless(false, false, false);
    for (int i = 0; i < 7; ++i) {
        int axis = i >> 1;  // 3: the brick itself
        ivec3 offset = ivec3(axis == 0, axis == 1, axis == 2) * (1 - 2 * (i & 1));
        int there = brick_index(wrap(place + offset, bricks));
        bool edited = edited_since_step(there);
        found.light = found.light || light_changed(there);
        found.blocks = found.blocks || edited;
        found.own_blocks = found.own_blocks || (edited && (axis & 1) == 1);
    }
    return found;
}

/// Did one of the brick's cells come into the volume with this frame? On each axis these lie from one place
/// on, as many as the volume moved.
bool has_entered(int brick) {
    ivec3 lowest = brick_place(brick) * brick_size;
    ivec3 scroll = volume_scroll();
    ivec3 first = volume_origin() + ivec3(greaterThan(scroll, ivec3(0))) * (volume_size - scroll);
    ivec3 begin = wrap(first - lowest, volume_size) - brick_size;
    ivec3 end = wrap(lowest - first, volume_size) - abs(scroll);
    return any(lessThan(min(begin, end) * abs(sign(scroll)), ivec3(0)));
}

void add_to_list(int brick, ivec2 length, int row) {
    uint slot = imageAtomicAdd(flood_list, length, 1u);
    imageStore(flood_list, ivec2(int(slot), row), uvec4(uint(brick)));
}

void main() {
    bool step_now = step_in_frame();
    bool scrolled = volume_scroll() != ivec3(0);
    bool all = step_stamp() == 1u || FLOODFILL_SKY != NONE;
    int count = step_now || scrolled ? brick_count : 0;
    int stride = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int brick = int(gl_GlobalInvocationID.x); brick < count; brick += stride) {
        Restless restless = restless_about(brick);
        if ((step_now && restless.own_blocks) || (scrolled && has_entered(brick)))
            add_to_list(brick, ready_list_length, ready_list);
        if (step_now && (all || restless.light || restless.blocks)) add_to_list(brick, step_list_length, step_list);
    }
}
