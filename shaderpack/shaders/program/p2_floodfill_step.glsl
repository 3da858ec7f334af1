// The step of p0_floodfill_step for FLOODFILL_STORAGE=IMAGE_3D, by a compute shader that leaves bricks at
// rest alone.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

#define READ_VOXELS
#define READ_LIGHT_IMAGE
#include "/include/voxel/propagation.glsl"
#include "/include/voxel/active_bricks.glsl"

layout(FLOODFILL_FORMAT) uniform writeonly image3D flood_next;
layout(r32ui) uniform readonly uimage2D flood_list;
layout(r32ui) uniform writeonly uimage2D flood_memory;

void main() {
    bool step_now = step_in_frame();
    ivec3 scroll = volume_scroll();
    uint bricks = imageLoad(flood_list, flood_list_length).r;
    for (uint i = gl_WorkGroupID.x; i < bricks; i += flood_groups) {
        int brick = int(imageLoad(flood_list, ivec2(i, 0)).r);
        ivec3 column = brick_column(brick, gl_LocalInvocationIndex);
        bool changed = false;
        for (int y = 0; y < flood_brick; ++y) {
            ivec3 cell = column + ivec3(0, y, 0);
            vec3 light = next_light(cell, scroll, step_now);
            changed = changed || light != stored_light(cell);
            imageStore(flood_next, cell, vec4(light, 1.0));
        }
        if (changed) imageStore(flood_memory, ivec2(brick, 0), uvec4(step_stamp()));
    }
}
