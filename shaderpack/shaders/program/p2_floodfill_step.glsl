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
    // Every invocation of a group has cells of the same brick.
    int cells = int(imageLoad(flood_list, flood_list_length).r) * 512;
    for (int i = int(gl_GlobalInvocationID.x); i < cells; i += flood_threads) {
        int brick = int(imageLoad(flood_list, ivec2(i / 512, 0)).r);
        ivec3 cell = brick_cell(brick, i % 512);
        vec3 light = next_light(cell, scroll, step_now);
        imageStore(flood_next, cell, vec4(light, 1.0));
        if (light != stored_light(cell)) imageStore(flood_memory, ivec2(brick, 0), uvec4(step_stamp()));
    }
}
