// How bright the picture is, and the exposure that follows it: one texel, kept from frame to frame.
#include "/settings.glsl"

#if defined VERTEX_STAGE

void main() { gl_Position = ftransform(); }

#else

#include "/include/post/exposure.glsl"

uniform sampler2D colortex0;
uniform sampler2D colortex9;
uniform float viewWidth;
uniform float viewHeight;
uniform float frameTime;

/* RENDERTARGETS: 9 */
layout(location = 0) out float out_exposure;

// A mean of logarithms over so many places of the picture: a bright window is one bright part, however bright it is.
const ivec2 places = ivec2(32, 18);

float mean_log_luminance() {
    float sum = 0.0;
    for (int y = 0; y < places.y; ++y)
        for (int x = 0; x < places.x; ++x) {
            vec2 place = (vec2(x, y) + 0.5) / vec2(places) * vec2(viewWidth, viewHeight);
            sum += log_luminance(texelFetch(colortex0, ivec2(place), 0).rgb);
        }
    return sum / float(places.x * places.y);
}

void main() {
    float wanted = exposure_for(mean_log_luminance());
    float before = texelFetch(colortex9, ivec2(0), 0).r;
    // The first frame has nothing to adapt from.
    out_exposure = before > 0.0 ? mix(wanted, before, exp(-frameTime / adaptation_time)) : wanted;
}

#endif
