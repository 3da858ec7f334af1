// Makes the light of the step before it what the rest of the frame and the next step read: in one
// image the order in which cells are done would show.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

#include "/include/voxel/active_bricks.glsl"

layout(FLOODFILL_FORMAT) uniform readonly image3D flood_next;
layout(FLOODFILL_FORMAT) uniform writeonly image3D flood_light;
layout(r32ui) uniform readonly uimage2D flood_list;

void main() {
    int cells = int(imageLoad(flood_list, flood_list_length).r) * 512;
    for (int i = int(gl_GlobalInvocationID.x); i < cells; i += flood_threads) {
        ivec3 cell = brick_cell(int(imageLoad(flood_list, ivec2(i / 512, 0)).r), i % 512);
        imageStore(flood_light, cell, imageLoad(flood_next, cell));
    }
}
