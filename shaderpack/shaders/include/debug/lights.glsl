// Views of the grid, instead of the lit scene (LIGHT_DEBUG).
//   SLICE   number of the slice, mod 8, as brightness; its tile's parity in blue
//   COUNT   r: lamps in the pixel's list / 1000, g: slice / 1000, b: tile / 1000; for reading by number
//   HEAT    lamps in the list, from blue over green at 16 to red at 256 and white where the list has no room for all
#if !defined INCLUDED_DEBUG_LIGHTS
#define INCLUDED_DEBUG_LIGHTS

#include "/include/lights/lit_by_lamps.glsl"

vec3 heat(float count) {
    float share = clamp(log2(max(count, 1.0)) / 8.0, 0.0, 1.0);
    return clamp(vec3(2.0 * share - 1.0, 1.0 - abs(2.0 * share - 1.0), 1.0 - 2.0 * share), 0.0, 1.0);
}

vec3 light_debug(Surface s) {
    if (s.sky) return vec3(0.0);
    ivec2 cluster = cluster_of((gbufferModelView * vec4(s.player, 1.0)).xyz);
    uint count = cluster_count(cluster);
#if LIGHT_DEBUG == LIGHT_DEBUG_COUNT
    return vec3(count, cluster.y, cluster.x) / 1000.0;
#elif LIGHT_DEBUG == LIGHT_DEBUG_SLICE
    int parity = (cluster.x / grid_columns + cluster.x % grid_columns) & 1;
    return vec3(vec2(cluster.y & 7) / 7.0, float(parity));
#else
    return count > list_capacity ? vec3(1.0) : heat(float(count));
#endif
}

#endif
