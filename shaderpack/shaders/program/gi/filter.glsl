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
// With this standard deviation as a share of its light, a pixel at the edge of a face mixes half as much with those on one side.
const float noise_of_edges = 0.2;

/* RENDERTARGETS: 6 */
layout(location = 0) out vec4 out_radiance;

/// Light that may mix with that of a pixel.
struct Tap {
    vec4 light;  // rgb light, a its variance
    vec4 plane;
};

Tap tap_at(ivec2 pixel) {
    vec4 plane = texelFetch(colortex5, pixel, 0);
    vec4 light = texelFetch(FILTER_SOURCE, pixel, 0);
#if FILTER_STEP == 1
    light.a = plane.w;
#endif
    light.a *= light.a;
    return Tap(light, plane);
}

/// How much of the light of one mixes with that of the other, 0..1: the noise of both counts, so that either counts as much for
/// the other, and no light is lost.
float mixes(Tap a, Tap b) {
    vec3 about = 0.5 * (a.light.rgb + b.light.rgb);
    float noise = 2.0 * noise_reach * noise_reach * (a.light.a + b.light.a);
    float near = exp(-squared_distance(a.light.rgb, b.light.rgb, about) / max(noise, 1e-20));
    return same_plane(a.plane, b.plane) ? near : 0.0;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = ivec2(viewWidth, viewHeight) - 1;
    Tap center = tap_at(pixel);

    // Light that rises evenly over a face keeps its place where pixels opposite to each other mix alike, which those at the edge of
    // the face cannot. They mix all the same while noise is large beside the light.
    float level = noise_of_edges * luminance(center.light.rgb);
    float one_sided = (center.light.a + 1e-20) / (center.light.a + level * level + 1e-20);
    vec4 sum = vec4(center.light.rgb, 1.0);
    float variance = center.light.a;
    for (int i = 0; i < 4; ++i) {
        ivec2 offset = ivec2(i % 3, i / 3) - 1;
        Tap a = tap_at(clamp(pixel + offset * FILTER_STEP, ivec2(0), last));
        Tap b = tap_at(clamp(pixel - offset * FILTER_STEP, ivec2(0), last));
        float kernel = offset.x == 0 || offset.y == 0 ? 0.5 : 0.25;
        vec2 weights = kernel * vec2(mixes(center, a), mixes(center, b));
        weights = min(weights, mix(weights.yx, weights, one_sided));
        sum += weights.x * vec4(a.light.rgb, 1.0) + weights.y * vec4(b.light.rgb, 1.0);
        variance += dot(weights * weights, vec2(a.light.a, b.light.a));
    }
    // Drivers may cut off what half floats do not hold.
    out_radiance = vec4(round_to_half(sum.rgb / sum.a), sqrt(variance) / sum.a);
}

#endif
