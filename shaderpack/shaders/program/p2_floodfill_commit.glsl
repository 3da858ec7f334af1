// Makes the light of the step before it what the rest of the frame and the next step read: in one
// image the order in which cells are done would show.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

#include "/include/voxel/volume.glsl"

layout(FLOODFILL_FORMAT) uniform readonly image3D flood_next;
layout(FLOODFILL_FORMAT) uniform writeonly image3D flood_light;

void main() {
    bool changed = frameCounter % FLOODFILL_INTERVAL == 0 || volume_scroll() != ivec3(0);
    int cells = changed ? VOLUME * VOLUME * VOLUME : 0;
    for (int i = int(gl_GlobalInvocationID.x); i < cells; i += 64 * 64) {
        ivec3 cell = ivec3(i % VOLUME, i / (VOLUME * VOLUME), i / VOLUME % VOLUME);
        imageStore(flood_light, cell, imageLoad(flood_next, cell));
    }
}
