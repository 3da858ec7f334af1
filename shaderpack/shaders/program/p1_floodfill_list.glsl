// Lists the bricks that this frame's step of the floodfill has to reckon.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

#define READ_VOXELS
#include "/include/voxel/voxel.glsl"
#include "/include/voxel/active_bricks.glsl"

layout(r32ui) uniform uimage2D flood_list;
layout(r32ui) uniform uimage2D flood_memory;

uint hash_of_blocks(int brick) {
    uint sum = 1u;  // air is not 0
    for (uint column = 0u; column < 64u; ++column) {
        ivec3 cell = brick_column(brick, column);
        for (int y = 0; y < flood_brick; ++y) {
            ivec2 texel = atlas_texel(cell + ivec3(0, y, 0));
            sum = (sum ^ packUnorm4x8(texelFetch(shadowcolor0, texel, 0))) * 16777619u;
        }
    }
    return sum;
}

bool changed_before(ivec3 place) {
    if (any(lessThan(place, ivec3(0))) || any(greaterThanEqual(place, ivec3(flood_bricks))))
        return false;
    return imageLoad(flood_memory, ivec2(brick_index(place), 0)).r + 1u == step_stamp();
}

/// Has the light of the brick or of one beside it changed?
bool restless(int brick) {
    ivec3 place = brick_place(brick);
    bool any_changed = changed_before(place);
    for (int axis = 0; axis < 3; ++axis) {
        ivec3 offset = ivec3(axis == 0, axis == 1, axis == 2);
        any_changed = any_changed || changed_before(place + offset) || changed_before(place - offset);
    }
    return any_changed;
}

void main() {
    bool scrolled = volume_scroll() != ivec3(0);
    // The numbers of steps begin anew after many hours.
    bool all = scrolled || step_stamp() == 1u || FLOODFILL_SKY != NONE;
    int bricks = step_in_frame() || scrolled ? flood_brick_count : 0;
    for (int brick = int(gl_GlobalInvocationID.x); brick < bricks; brick += int(flood_groups) * 64) {
        uint blocks = hash_of_blocks(brick);
        bool edited = imageLoad(flood_memory, ivec2(brick, 1)).r != blocks;
        imageStore(flood_memory, ivec2(brick, 1), uvec4(blocks));
        if (all || edited || restless(brick)) {
            uint slot = imageAtomicAdd(flood_list, flood_list_length, 1u);
            imageStore(flood_list, ivec2(int(slot), 0), uvec4(uint(brick)));
        }
    }
}
