// Makes cells of the floodfill's image ready for a step where blocks changed: empties those that came into the
// volume, and notes of all what a step has to know of their blocks; lamps and walls take the light that they send.
#include "/settings.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(16, 1, 1);

#define HAS_VOXEL_READS
#include "/include/voxels/voxel.glsl"
#include "/include/floodfill/active_bricks.glsl"

layout(FLOODFILL_FORMAT) uniform FLOODFILL_IMAGE flood_light;
layout(r32ui) uniform readonly uimage2D flood_list;

uint traits_of(int code, int code_below, int code_above) {
    bool closed_down = code == voxel_slab_bottom || code_below == voxel_slab_top;
    bool closed_up = code == voxel_slab_top || code_above == voxel_slab_bottom;
    return uint(is_opaque_voxel(code)) * trait_fixed | uint(closed_down) * trait_closed_down |
           uint(closed_up) * trait_closed_up | uint(is_filter_voxel(code)) * trait_filter;
}

void make_ready(ivec3 place) {
    ivec3 cell = stored_at(place);
    Voxel v = voxel_at(cell);
    uint traits = traits_of(v.code, voxel_at(cell - ivec3(0, 1, 0)).code, voxel_at(cell + ivec3(0, 1, 0)).code);
    bool anew = is_opaque_voxel(v.code) || entered(cell);
    FLOOD_TEXEL fresh = flood_texel_of(is_lamp_voxel(v.code) ? lamp_radiance(v) : vec3(0.0), traits);
    for (uint side = 0u; side < 2u; ++side) {
        ivec3 texel = flood_texel(place, side);
        imageStore(flood_light, texel, anew ? fresh : with_traits(imageLoad(flood_light, texel), traits));
    }
}

void main() {
    uint listed = imageLoad(flood_list, ready_list_length).r;
    for (uint i = gl_WorkGroupID.x; i < listed; i += gl_NumWorkGroups.x) {
        int brick = int(imageLoad(flood_list, ivec2(i, ready_list)).r);
        ivec3 lowest = brick_column(brick, gl_LocalInvocationIndex);
        for (int y = 0; y < brick_size; ++y) make_ready(lowest + ivec3(0, y, 0));
    }
}
