// Waves of open water: sines that each move as deep water does (angular frequency sqrt(g k)), in a pattern that repeats
// every 64 blocks. Only the normal; the surface stays where the mesh has it.
#if !defined INCLUDED_WATER_WAVES
#define INCLUDED_WATER_WAVES

#include "/include/uniforms.glsl"
#include "/include/math/sampling.glsl"

uniform float frameTimeCounter;

const float wave_period = 64.0;      // blocks
const float wave_clock = 3600.0;     // seconds after which frameTimeCounter starts again
const float wave_gravity = 9.81;     // blocks / s^2
const float calm_variance = 0.0004;  // of the slopes of ripples shorter than all of these

// Waves along x and z in a period, and the largest slope of each.
const int wave_count = 7;
const vec3 wave_table[wave_count] =
    vec3[](vec3(5, 9, 0.028), vec3(-11, 7, 0.026), vec3(17, -4, 0.024), vec3(13, 21, 0.022), vec3(-23, -19, 0.022),
           vec3(31, -27, 0.020), vec3(-9, 47, 0.020));

struct Waves {
    vec3 normal;     // world axes, up
    float variance;  // of the slope along each axis, of waves shorter than a pixel
};

/// At a place of the surface, player space.
Waves waves_at(vec3 player) {
    vec2 place = vec2(cameraPositionInt.xz & (int(wave_period) - 1)) + cameraPositionFract.xz + player.xz;
    // A pixel that is long in one direction only blurs what runs that way; the longer side is the safe one for both.
    vec2 across = fwidth(player.xz);
    float pixel = max(across.x, across.y);
    vec2 slope = vec2(0.0);
    float variance = calm_variance;
    for (int i = 0; i < wave_count; ++i) {
        vec2 k = wave_table[i].xy * (2.0 * pi / wave_period);
        float turns = round(sqrt(wave_gravity * length(k)) * wave_clock / (2.0 * pi));
        float phase = dot(k, place) - 2.0 * pi * fract(turns / wave_clock * frameTimeCounter) + 1.7 * float(i);
        float steep = wave_table[i].z * (1.0 + rainStrength);
        float seen = exp(-0.25 * dot(k, k) * pixel * pixel);
        slope += normalize(k) * (steep * seen * cos(phase));
        variance += 0.25 * steep * steep * (1.0 - seen * seen);
    }
    return Waves(normalize(vec3(-slope.x, 1.0, -slope.y)), variance);
}

/// What small waves mirror of a light, for irradiance 1 on a plane facing it: microfacets whose slopes are normally
/// distributed (Cook and Torrance 1982), without shadowing; reflectance as of the water's Fresnel term.
float wave_highlight(vec3 n, float variance, vec3 v, vec3 l) {
    vec3 h = normalize(v + l);
    float cosine = dot(h, n);
    if (cosine < 0.1 || dot(l, n) <= 0.0) return 0.0;
    float tangent2 = 1.0 / (cosine * cosine) - 1.0;
    float density = exp(-0.5 * tangent2 / variance) / (2.0 * pi * variance * pow(cosine, 4.0));
    float fresnel = 0.02 + 0.98 * pow(1.0 - max(dot(v, h), 0.0), 5.0);
    return fresnel * density / (4.0 * max(dot(n, v), 0.1));
}

#endif
