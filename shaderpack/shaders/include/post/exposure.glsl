// An exposure that adapts as eyes do: partly, so that nights stay darker than days.
#if !defined INCLUDED_POST_EXPOSURE
#define INCLUDED_POST_EXPOSURE

#include "/include/math/color.glsl"

const float adaptation_time = 0.4;   // seconds until 1/e of a step is left
const float adapted_share = 0.6;     // of a step of the scene, as powers
const float usual_luminance = 0.45;  // of a scene by day, whose exposure is 1
const vec2 adapted_range = vec2(0.5, 4.0);

/// To the base 2. Black and what is no number count as very dark.
float log_luminance(vec3 color) {
    float light = luminance(color);
    return light > 1e-4 ? log2(min(light, 1e4)) : log2(1e-4);
}

/// Factor of radiance for a scene of this mean.
float exposure_for(float mean_log) {
    return clamp(exp2(adapted_share * (log2(usual_luminance) - mean_log)), adapted_range.x, adapted_range.y);
}

#endif
