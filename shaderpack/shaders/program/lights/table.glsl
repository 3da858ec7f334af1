// Makes the table of the lamps from the cells, a row along x each, after those before it; and room for
// the lists.
#include "/settings.glsl"

#include "/include/lights/changes.glsl"
#include "/include/lights/lamp_light.glsl"
#if HAS_LIGHT_GRID
#include "/include/lights/grid_rest.glsl"
#endif

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

layout(r32ui) uniform readonly uimage3D lamp_cells;
layout(rgba32f) uniform writeonly image2D light_table;

uint lamps_before(int y, int z) {
    uint sum = 0u;
    for (int layer = 0; layer < z; ++layer) sum += tally_of(ivec2(lamp_volume, layer));
    for (int row = 0; row < y; ++row) sum += tally_of(ivec2(row, z));
    return sum;
}

void enter(uint slot, ivec3 cell, uint lamp) {
    if (slot >= table_capacity) return;
    Light light = make_light(cell, lamp);
    ivec2 texel = table_texel(slot);
    imageStore(light_table, texel, vec4(light.place, light.inverse));
    imageStore(light_table, texel + ivec2(1, 0), vec4(light.intensity, light.radius));
}

void main() {
    int rows = lights_changed() ? lamp_volume * lamp_volume : 0;
    int threads = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
#if HAS_LIGHT_GRID
    clear_rests(int(gl_GlobalInvocationID.x), threads);
#endif
    for (int i = int(gl_GlobalInvocationID.x); i < rows; i += threads) {
        int y = i % lamp_volume;
        int z = i / lamp_volume;
        uint left = tally_of(ivec2(y, z));
        if (left == 0u) continue;
        uint slot = lamps_before(y, z);
        for (int x = 0; x < lamp_volume && left > 0u; ++x) {
            uint lamp = imageLoad(lamp_cells, ivec3(x, y, z)).r;
            if (lamp == 0u) continue;
            enter(slot, ivec3(x, y, z), lamp);
            slot += 1u;
            left -= 1u;
        }
    }
}
