// The step of p0_floodfill_step for FLOODFILL_STORAGE=IMAGE_3D, by a compute shader.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

#define READ_VOXELS
#define READ_LIGHT_IMAGE
#include "/include/voxel/propagation.glsl"

layout(FLOODFILL_FORMAT) uniform writeonly image3D flood_next;

void main() {
    bool step_now = frameCounter % FLOODFILL_INTERVAL == 0;
    ivec3 scroll = volume_scroll();
    // A loop without turns is cheap where a branch round a whole program is not.
    int cells = step_now || scroll != ivec3(0) ? VOLUME * VOLUME * VOLUME : 0;
    for (int i = int(gl_GlobalInvocationID.x); i < cells; i += 64 * 64) {
        ivec3 cell = ivec3(i % VOLUME, i / (VOLUME * VOLUME), i / VOLUME % VOLUME);
        imageStore(flood_next, cell, vec4(next_light(cell, scroll, step_now), 1.0));
    }
}
