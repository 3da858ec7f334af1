// Takes away what lists without room left in the bits, before they are set anew.
#if !defined INCLUDED_LIGHTS_GRID_REST
#define INCLUDED_LIGHTS_GRID_REST

#include "/include/lights/changes.glsl"
#include "/include/lights/grid.glsl"

layout(r32ui) uniform uimage3D light_bits;

/// Thread `first` of `threads`.
void clear_rests(int first, int threads) {
    int clusters = grid_changed() ? grid_clusters : 0;
    for (int i = first; i < clusters; i += threads) {
        ivec2 cluster = ivec2(i % grid_tiles, i / grid_tiles);
        uint rest = packed_rest(imageLoad(light_bits, ivec3(length_word, cluster)).r);
        if (rest == 0u) continue;
        for (int word = int(rest) - 1; word < length_word; ++word)
            imageStore(light_bits, ivec3(word, cluster), uvec4(0u));
    }
}

#endif
