// The step of floodfill/atlas_step for FLOODFILL_STORAGE=IMAGE_3D, by a compute shader that leaves bricks at
// rest alone.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(16, 1, 1);

#define HAS_VOXEL_READS
#define HAS_FLOOD_WRITES
#if FLOODFILL_RULE == PUBLISHED && FLOODFILL_SKY == NONE
#include "/include/floodfill/power_step.glsl"
#else
#include "/include/floodfill/propagation.glsl"
#endif
#include "/include/floodfill/active_bricks.glsl"

layout(r32ui) uniform uimage2D flood_list;
layout(r32ui) uniform writeonly uimage2D flood_memory;
layout(r32ui) uniform writeonly uimage2D flood_state;

#if FLOODFILL_RULE != PUBLISHED || FLOODFILL_SKY != NONE
/// Is something of the column's light new?
bool step_column(ivec3 lowest, uint stamp, out uint filters) {
    filters = 0u;
    bool changed = false;
    for (int y = 0; y < brick_size; ++y) {
        ivec3 place = lowest + ivec3(0, y, 0);
        FLOOD_TEXEL before = imageLoad(flood_light, flood_texel(place, stamp - 1u));
        FLOOD_TEXEL now = flood_texel_of(next_light(stored_at(place), ivec3(0), true), traits_in(before));
        changed = changed || now.rgb != before.rgb;
        imageStore(flood_light, flood_texel(place, stamp), now);
    }
    return changed;
}
#endif

void main() {
    uint listed = imageLoad(flood_list, step_list_length).r;
    if (gl_GlobalInvocationID.x == 0u) {
        imageStore(flood_state, ivec2(0, 0), uvec4(listed));
        imageStore(flood_state, ivec2(1, 0), uvec4(uint(brick_count)));
    }
    for (uint i = gl_WorkGroupID.x; i < listed; i += gl_NumWorkGroups.x) {
        int brick = int(imageLoad(flood_list, ivec2(i, step_list)).r);
        uint filters;
        if (step_column(brick_column(brick, gl_LocalInvocationIndex), step_stamp(), filters))
            imageStore(flood_memory, ivec2(brick, 0), uvec4(step_stamp()));
        if (filters != 0u) imageStore(flood_list, ivec2(brick, filter_flags), uvec4(1u));
    }
}
