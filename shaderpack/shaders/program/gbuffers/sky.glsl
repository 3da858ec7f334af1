// Stars, sun and moon. The sky itself is added by deferred6, so that it needs no geometry.
// PROGRAM_TEXTURED: sun and moon quads.
#include "/settings.glsl"
#include "/include/uniforms.glsl"
#include "/include/math/color.glsl"

#if defined VERTEX_STAGE

out vec2 uv;
out vec4 tint;

void main() {
    gl_Position = ftransform();
    uv = (gl_TextureMatrix[0] * gl_MultiTexCoord0).xy;
    tint = gl_Color;
}

#else

in vec2 uv;
in vec4 tint;

#if defined PROGRAM_TEXTURED
uniform sampler2D gtexture;
#endif

/* RENDERTARGETS: 0 */
layout(location = 0) out vec4 out_color;

void main() {
#if DIRECT_LIGHT == NONE
    discard;  // the reference (docs/method.md) has none of them
#endif
#if defined PROGRAM_TEXTURED
    vec4 color = texture(gtexture, uv) * tint;
    out_color = vec4(4.0 * to_linear(color.rgb), color.a);
#else
    if (renderStage != MC_RENDER_STAGE_STARS) discard;
    out_color = vec4(0.3 * tint.rgb, tint.a);
#endif
}

#endif
