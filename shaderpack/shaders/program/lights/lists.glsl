// Turns the bits of each cluster into its list, lamps in the table's order, and empties them. What
// has no room there keeps its bit; how much that is, is counted (light_state).
#include "/settings.glsl"

#include "/include/lights/changes.glsl"
#include "/include/lights/grid.glsl"

layout(local_size_x = 64) in;
const ivec3 workGroups = ivec3(64, 1, 1);

layout(r32ui) uniform uimage3D light_bits;
layout(r16ui) uniform writeonly uimage3D light_list;

/// Lamps of the cluster, and the first word that keeps bits, plus 1; 0 for none.
uvec2 list_lamps(ivec2 cluster, int words) {
    uint count = 0u;
    uint rest = 0u;
    for (int word = 0; word < words; ++word) {
        uint bits = imageLoad(light_bits, ivec3(word, cluster)).r;
        if (bits == 0u) continue;
        for (; bits != 0u && count < list_capacity; bits &= bits - 1u) {
            imageStore(light_list, ivec3(int(count), cluster),
                       uvec4(uint(word * 32 + findLSB(bits))));
            count += 1u;
        }
        imageStore(light_bits, ivec3(word, cluster), uvec4(bits));
        if (bits != 0u && rest == 0u) rest = uint(word + 1);
        count += uint(bitCount(bits));
    }
    return uvec2(count, rest);
}

void main() {
    int words = (int(listed_lamps()) + 31) / 32;
    int clusters = grid_changed() ? grid_clusters : 0;
    int threads = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int i = int(gl_GlobalInvocationID.x); i < clusters; i += threads) {
        ivec2 cluster = ivec2(i % grid_tiles, i / grid_tiles);
        uvec2 found = list_lamps(cluster, words);
        imageStore(light_bits, ivec3(length_word, cluster), uvec4(pack_length(found.x, found.y)));
        imageAtomicAdd(lamp_tally, lamp_entries, found.x);
        imageAtomicMax(lamp_tally, lamp_longest, found.x);
        if (found.y > 0u) imageAtomicAdd(lamp_tally, lamp_spilled, found.x - list_capacity);
    }
}
