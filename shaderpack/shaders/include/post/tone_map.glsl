// Radiance to what a display can show, both linear.
#if !defined INCLUDED_POST_TONE_MAP
#define INCLUDED_POST_TONE_MAP

#include "/include/math/color.glsl"

vec3 tone_map_reinhard(vec3 color) {
    // On luminance, so that hue stays.
    return color / (1.0 + luminance(color));
}

// A filmic curve x (a x + b) / (x (c x + d) + e): toe, straight part and shoulder of the ACES look.
// 0.18 stays 0.18, large values reach 1.
vec3 tone_map_aces(vec3 x) { return x * (2.2 * x + 0.05) / (x * (2.2 * x + 0.85) + 0.2217); }

vec3 tone_map(vec3 color) {
#if TONE_MAP == TONE_MAP_ACES
    return tone_map_aces(color);
#elif TONE_MAP == TONE_MAP_REINHARD
    return tone_map_reinhard(color);
#else
    return color;
#endif
}

#endif
