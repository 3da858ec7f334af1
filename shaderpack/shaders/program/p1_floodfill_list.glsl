// Makes the floodfill's image ready for this frame: empties cells that came into the volume, puts
// lamps and walls where blocks changed, and lists the bricks that the step has to reckon.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(8, 1, 1);

#define READ_VOXELS
#include "/include/voxel/voxel.glsl"
#include "/include/voxel/active_bricks.glsl"

layout(FLOODFILL_FORMAT) uniform writeonly image3D flood_light;
layout(r32ui) uniform uimage2D flood_list;
layout(r32ui) uniform readonly uimage2D flood_memory;
layout(r32ui) uniform readonly uimage2D voxel_memory;

bool edited_since_step(int brick) {
    return changed_within(imageLoad(voxel_memory, ivec2(brick, 1)).r, FLOODFILL_INTERVAL);
}

bool light_changed(int brick) {
    return imageLoad(flood_memory, ivec2(brick, 0)).r + 1u == step_stamp();
}

bool restless(ivec3 place) {
    int brick = brick_index(wrap(place, bricks));
    return edited_since_step(brick) || light_changed(brick);
}

/// Is the brick, or one beside it, restless? Those at the edge of the volume count as neighbours.
bool is_active(int brick) {
    ivec3 place = brick_place(brick);
    bool near = restless(place);
    for (int axis = 0; axis < 3; ++axis) {
        ivec3 offset = ivec3(axis == 0, axis == 1, axis == 2);
        near = near || restless(place + offset) || restless(place - offset);
    }
    return near;
}

void store_both(ivec3 place, vec3 light) {
    for (uint side = 0u; side < 2u; ++side)
        imageStore(flood_light, flood_texel(place, side), vec4(light, 1.0));
}

/// Light of cells that no step reckons: none where the volume was not before, a lamp's, none in walls.
void prepare_cells(int brick, bool edited, bool scrolled) {
    int cells = edited || scrolled ? 512 : 0;
    for (int i = 0; i < cells; ++i) {
        ivec3 place = brick_place(brick) * brick_size + (ivec3(i, i >> 3, i >> 6) & 7);
        ivec3 cell = stored_at(place);
        Voxel v = voxel_at(cell);
        bool fixed_light = edited && is_opaque_voxel(v.code);
        vec3 light = fixed_light && is_lamp_voxel(v.code) ? to_stored(lamp_radiance(v)) : vec3(0.0);
        if (fixed_light || entered(cell)) store_both(place, light);
    }
}

void main() {
    bool step_now = step_in_frame();
    bool scrolled = volume_scroll() != ivec3(0);
    bool all = step_stamp() == 1u || FLOODFILL_SKY != NONE;
    int count = step_now || scrolled ? brick_count : 0;
    int stride = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int brick = int(gl_GlobalInvocationID.x); brick < count; brick += stride) {
        prepare_cells(brick, step_now && edited_since_step(brick), scrolled);
        if (step_now && (all || is_active(brick))) {
            uint slot = imageAtomicAdd(flood_list, flood_list_length, 1u);
            imageStore(flood_list, ivec2(int(slot), 0), uvec4(uint(brick)));
        }
    }
}
