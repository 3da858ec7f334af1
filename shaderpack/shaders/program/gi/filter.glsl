// Smooths the gathered light within each face: three of these, FILTER_STEP 1, 2 and 4 pixels apart,
// make a 15 x 15 kernel (the "a trous" scheme of Dammertz et al. 2010).
#include "/settings.glsl"

#if defined VERTEX_STAGE

#include "/include/gi/rest.glsl"

void main() { gl_Position = drawn_corner(ftransform()); }

#else

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

// Frames after which the mean is trusted more than its neighbours, so that it converges.
const float filter_frames = 64.0;

/* RENDERTARGETS: 6 */
layout(location = 0) out vec4 out_radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = ivec2(viewWidth, viewHeight) - 1;
    vec4 center = texelFetch(FILTER_SOURCE, pixel, 0);
    vec4 plane = texelFetch(colortex5, pixel, 0);
    float trust = min(1.0, filter_frames / max(center.a, 1.0));

    vec4 sum = vec4(center.rgb, 1.0);
    for (int i = 0; i < 9; ++i) {
        if (i == 4) continue;
        ivec2 offset = ivec2(i % 3, i / 3) - 1;
        ivec2 tap = clamp(pixel + offset * FILTER_STEP, ivec2(0), last);
        float kernel = offset.x == 0 || offset.y == 0 ? 0.5 : 0.25;
        float weight = same_plane(texelFetch(colortex5, tap, 0), plane) ? trust * kernel : 0.0;
        sum += weight * vec4(texelFetch(FILTER_SOURCE, tap, 0).rgb, 1.0);
    }
    out_radiance = vec4(sum.rgb / sum.a, center.a);
}

#endif
