// Gives the cells of glass and water that were stepped by power_step their colour; with the other rules, and in the atlas,
// next_light() of include/floodfill/propagation.glsl does. A program of its own, and a loop that only finds
// the next brick: drivers compute what stands under a condition for every cell, and this costs as much as the step.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(4, 1, 1);

#define HAS_VOXEL_READS
#define HAS_FLOOD_WRITES
#include "/include/floodfill/power_step.glsl"
#include "/include/floodfill/active_bricks.glsl"

layout(r32ui) uniform readonly uimage2D flood_list;
layout(r32ui) uniform writeonly uimage2D flood_memory;

/// Number in the list, from `i` on in this group's steps, of a brick with such cells; `listed` if there is none.
uint next_brick(uint i, uint listed) {
    while (i < listed && imageLoad(flood_list, ivec2(imageLoad(flood_list, ivec2(i, step_list)).r, filter_flags)).r == 0u)
        i += gl_NumWorkGroups.x;
    return i;
}

/// Is the cell's light new?
bool tint_cell(ivec3 place, uint stamp) {
    ivec3 texel = flood_texel(place, stamp);
    uvec2 before = word_at(flood_texel(place, stamp - 1u));
    if ((before.y & trait_filter) == 0u) return false;
    vec3 color = voxel_at(stored_at(place)).color;
    vec3 power = power_of(word_at(texel)) * pow(max(color, vec3(1e-4)), vec3(FLOODFILL_GAMMA));
    bool same = rests(power, power_of(before));
    imageStore(flood_light, texel, same ? before.xyxy : texel_of_power(power, before.y & 0xFFFF0000u));
    return !same;
}

void main() {
    uint listed = imageLoad(flood_list, step_list_length).r;
    for (uint i = next_brick(gl_WorkGroupID.x, listed); i < listed; i = next_brick(i + gl_NumWorkGroups.x, listed)) {
        int brick = int(imageLoad(flood_list, ivec2(i, step_list)).r);
        ivec3 lowest = brick_column(brick, gl_LocalInvocationIndex);
        bool changed = false;
        for (int y = 0; y < brick_size; ++y) changed = tint_cell(lowest + ivec3(0, y, 0), step_stamp()) || changed;
        if (changed) imageStore(flood_memory, ivec2(brick, 0), uvec4(step_stamp()));
    }
}
