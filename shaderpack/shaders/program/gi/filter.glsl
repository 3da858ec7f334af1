// Smooths the gathered light within each face: three of these, FILTER_STEP 1, 2 and 4 pixels apart,
// make a 15 x 15 kernel (the "a trous" scheme of Dammertz et al. 2010). What differs by more than noise does not mix
// (Schied et al. 2017, "Spatiotemporal Variance-Guided Filtering"), so that edges of light stay. The first pass estimates
// the noise from the pixels about it.
#include "/settings.glsl"

#if defined VERTEX_STAGE

#include "/include/gi/rest.glsl"

void main() { gl_Position = drawn_corner(ftransform()); }

#else

#include "/include/math/color.glsl"
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

// Light mixes by exp(-1) where it differs by so many standard deviations.
const float noise_reach = 6.0;
// Frames after which the mean is trusted more than its neighbours, so that it converges.
const float filter_frames = 64.0;

/* RENDERTARGETS: 6 */
layout(location = 0) out vec4 out_radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = ivec2(viewWidth, viewHeight) - 1;
    vec4 center = texelFetch(FILTER_SOURCE, pixel, 0);
    vec4 plane = texelFetch(colortex5, pixel, 0);
#if FILTER_STEP == 1
    float trust = min(1.0, filter_frames / max(center.a, 1.0));
#endif

    vec4 sum = vec4(center.rgb, 1.0);
    float squares = 1.0;           // of the weights
    vec2 differences = vec2(0.0);  // sum of squares, expected number of variances in it
    for (int i = 0; i < 9; ++i) {
        if (i == 4) continue;
        ivec2 offset = ivec2(i % 3, i / 3) - 1;
        ivec2 tap = clamp(pixel + offset * FILTER_STEP, ivec2(0), last);
        vec4 beside = texelFetch(FILTER_SOURCE, tap, 0);
        float kernel = offset.x == 0 || offset.y == 0 ? 0.5 : 0.25;
        float weight = same_plane(texelFetch(colortex5, tap, 0), plane) ? kernel : 0.0;
        float difference = luminance(beside.rgb) - luminance(center.rgb);
#if FILTER_STEP == 1
        differences += vec2(difference * difference, 2.0) * float(weight > 0.0);
        weight *= trust;
#else
        // The larger of both, so that either counts as much for the other, and no light is lost.
        weight *= exp(-abs(difference) / max(noise_reach * max(center.a, beside.a), 1e-12));
#endif
        sum += weight * vec4(beside.rgb, 1.0);
        squares += weight * weight;
    }
#if FILTER_STEP == 1
    float noise = sqrt(trust * differences.x / max(differences.y, 1.0));
#else
    float noise = center.a;
#endif
    out_radiance = vec4(sum.rgb / sum.a, noise * sqrt(squares) / sum.a);
}

#endif
