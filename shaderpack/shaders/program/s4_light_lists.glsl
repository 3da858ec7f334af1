// Turns the bits of each cluster into its list, lamps in the table's order, and empties them. A list
// that has no room ends; how much is missing is counted (light_state).
#include "/settings.glsl"

#include "/include/lights/changes.glsl"
#include "/include/lights/grid.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

layout(r32ui) uniform uimage3D light_bits;
layout(r16ui) uniform writeonly uimage3D light_list;

/// Lamps of the cluster, whether there is room or not.
uint list_lamps(ivec2 cluster, int words) {
    uint count = 0u;
    for (int word = 0; word < words; ++word) {
        uint bits = imageLoad(light_bits, ivec3(word, cluster)).r;
        if (bits == 0u) continue;
        imageStore(light_bits, ivec3(word, cluster), uvec4(0u));
        for (; bits != 0u; bits &= bits - 1u) {
            if (count < list_capacity)
                imageStore(light_list, ivec3(int(count), cluster),
                           uvec4(uint(word * 32 + findLSB(bits))));
            count += 1u;
        }
    }
    return count;
}

void main() {
    int words = (int(listed_lamps()) + 31) / 32;
    int clusters = grid_changed() ? grid_clusters : 0;
    int threads = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < clusters; i += threads) {
        ivec2 cluster = ivec2(i % grid_tiles, i / grid_tiles);
        uint count = list_lamps(cluster, words);
        imageStore(light_bits, ivec3(length_word, cluster), uvec4(min(count, list_capacity)));
        imageAtomicAdd(lamp_tally, lamp_entries, count);
        imageAtomicMax(lamp_tally, lamp_longest, count);
        if (count > list_capacity) imageAtomicAdd(lamp_tally, lamp_dropped, count - list_capacity);
    }
}
