// What the opaque gbuffers leave for the deferred passes.
#if !defined INCLUDED_GBUFFER
#define INCLUDED_GBUFFER

#include "/include/uniforms.glsl"
#include "/include/math/color.glsl"
#include "/include/math/encoding.glsl"

// Material byte: emission 0..15, plus this for surfaces lit from both sides (plants, leaves), plus so
// many times the class of gloss (include/brdf/glossy.glsl).
const float material_thin = 16.0;
const float material_gloss = 32.0;

struct Surface {
    vec3 player;   // relative to the camera, world axes, blocks
    vec3 normal;   // world axes
    vec3 albedo;   // linear
    vec2 light;    // block, sky: 0..1
    float emission;  // level 0..15
    bool thin;
    int gloss;       // class, 0: diffuse
    bool sky;      // nothing was drawn: only player is valid, as a direction
};

#if defined HAS_GBUFFER_READS
uniform sampler2D colortex1;
uniform sampler2D colortex2;
uniform sampler2D depthtex0;

vec3 player_position(vec2 uv, float depth) {
    vec4 view = gbufferProjectionInverse * vec4(vec3(uv, depth) * 2.0 - 1.0, 1.0);
    return (gbufferModelViewInverse * vec4(view.xyz / view.w, 1.0)).xyz;
}

Surface read_surface(ivec2 pixel) {
    float depth = texelFetch(depthtex0, pixel, 0).r;
    vec4 color = texelFetch(colortex1, pixel, 0);
    vec4 geometry = texelFetch(colortex2, pixel, 0);
    float material = floor(color.a * 255.0 + 0.5);
    Surface s;
    s.player = player_position((vec2(pixel) + 0.5) / vec2(viewWidth, viewHeight), depth);
    s.normal = decode_normal(geometry.xy);
    s.albedo = to_linear(color.rgb);
    s.light = geometry.zw;
    s.gloss = int(material / material_gloss);
    material -= float(s.gloss) * material_gloss;
    s.thin = material >= material_thin;
    s.emission = s.thin ? material - material_thin : material;
    s.sky = depth >= 1.0;
    return s;
}
#endif

#endif
