// Notes which bricks' blocks differ from the frame before. Bricks at the edge change as the volume moves.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(8, 1, 1);

#include "/include/voxels/changes.glsl"
#include "/include/voxels/octants.glsl"

layout(r32ui) uniform uimage2D voxel_memory;

bool has_lake() { return imageLoad(voxel_sums, lake_now).r != 0u; }

/// Water is known by its surface, and what is below it has no face: with a lake, now or a frame ago, a change
/// is one of the whole column of bricks.
void note_change(ivec3 place) {
    bool lake = has_lake() || changed_within(imageLoad(voxel_memory, lake_seen).r, 2);
    int height = lake ? bricks.y : 1;
    for (int i = 0; i < height; ++i) {
        ivec3 there = ivec3(place.x, (place.y + i) % bricks.y, place.z);
        imageStore(voxel_memory, ivec2(brick_index(there), 1), uvec4(change_stamp()));
    }
    imageStore(voxel_memory, change_of_any, uvec4(change_stamp()));
}

void main() {
    if (gl_GlobalInvocationID.x == 0u && has_lake()) imageStore(voxel_memory, lake_seen, uvec4(change_stamp()));
    int stride = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int brick = int(gl_GlobalInvocationID.x); brick < brick_count; brick += stride) {
        uint now = imageLoad(voxel_sums, ivec2(brick, 0)).r;
        if (now == imageLoad(voxel_memory, ivec2(brick, 0)).r) continue;
        imageStore(voxel_memory, ivec2(brick, 0), uvec4(now));
        note_change(brick_place(brick));
    }
}
