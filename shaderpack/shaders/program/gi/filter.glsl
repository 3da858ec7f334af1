// Smooths the gathered light within each face: three of these, FILTER_STEP 1, 2 and 4 pixels apart,
// make a 15 x 15 kernel (the "a trous" scheme of Dammertz et al. 2010). What differs by more than noise does not mix
// (include/gi/noise.glsl), so that edges of light stay, and means of many frames keep what they have found.
#include "/settings.glsl"

#if defined VERTEX_STAGE

#include "/include/gi/rest.glsl"

void main() { gl_Position = drawn_corner(ftransform()); }

#else

#include "/include/gi/noise.glsl"
#include "/include/plane.glsl"
#include "/include/uniforms.glsl"

#if FILTER_STEP == 1
uniform sampler2D colortex3;
#define FILTER_SOURCE colortex3
#else
uniform sampler2D colortex6;
#define FILTER_SOURCE colortex6
#endif
uniform sampler2D colortex5;

// Light mixes by exp(-1/2) where it differs by so many standard deviations.
const float noise_reach = 3.5;

/* RENDERTARGETS: 6 */
layout(location = 0) out vec4 out_radiance;

/// rgb light, a its variance.
vec4 noisy_light(ivec2 pixel, vec4 plane) {
    vec4 light = texelFetch(FILTER_SOURCE, pixel, 0);
#if FILTER_STEP == 1
    light.a = plane.w;
#endif
    light.a *= light.a;
    return light;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = ivec2(viewWidth, viewHeight) - 1;
    vec4 plane = texelFetch(colortex5, pixel, 0);
    vec4 center = noisy_light(pixel, plane);

    vec4 sum = vec4(center.rgb, 1.0);
    float variance = center.a;
    for (int i = 0; i < 9; ++i) {
        if (i == 4) continue;
        ivec2 offset = ivec2(i % 3, i / 3) - 1;
        ivec2 tap = clamp(pixel + offset * FILTER_STEP, ivec2(0), last);
        vec4 tap_plane = texelFetch(colortex5, tap, 0);
        vec4 beside = noisy_light(tap, tap_plane);
        float kernel = offset.x == 0 || offset.y == 0 ? 0.5 : 0.25;
        float weight = same_plane(tap_plane, plane) ? kernel : 0.0;
        // The noise of both, so that either counts as much for the other, and no light is lost.
        float noise = 2.0 * noise_reach * noise_reach * (center.a + beside.a);
        weight *= exp(-squared_distance(center.rgb, beside.rgb, 0.5 * (center.rgb + beside.rgb)) / max(noise, 1e-20));
        sum += weight * vec4(beside.rgb, 1.0);
        variance += weight * weight * beside.a;
    }
    // Drivers may cut off what half floats do not hold.
    out_radiance = vec4(round_to_half(sum.rgb / sum.a), sqrt(variance) / sum.a);
}

#endif
