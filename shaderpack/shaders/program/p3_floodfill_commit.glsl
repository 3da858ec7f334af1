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
    uint bricks = imageLoad(flood_list, flood_list_length).r;
    for (uint i = gl_WorkGroupID.x; i < bricks; i += flood_groups) {
        ivec3 column = brick_column(int(imageLoad(flood_list, ivec2(i, 0)).r), gl_LocalInvocationIndex);
        for (int y = 0; y < flood_brick; ++y) {
            ivec3 cell = column + ivec3(0, y, 0);
            imageStore(flood_light, cell, imageLoad(flood_next, cell));
        }
    }
}
