// Opaque geometry into the G-buffer. PROGRAM_BASIC: without a texture. PROGRAM_GLOW: lightning, beams and eyes, which
// the game adds to the picture and which here glow. PROGRAM_ENTITIES: red when hurt.
#include "/settings.glsl"
#include "/include/blocks.glsl"
#include "/include/gbuffer.glsl"
#include "/include/gi/ambient.glsl"

#if defined VERTEX_STAGE

in vec2 mc_Entity;
in vec4 at_midBlock;

out vec2 uv;
out vec4 tint;
out vec2 light;
flat out vec3 normal;
flat out float material;
#if LAMPS_FORWARD
out vec3 player;
#endif

void main() {
    gl_Position = ftransform();
    uv = (gl_TextureMatrix[0] * gl_MultiTexCoord0).xy;
    tint = gl_Color;
    // Texture coordinates of the lightmap back to levels.
    vec2 lightmap = (gl_TextureMatrix[1] * gl_MultiTexCoord1).xy;
    light = clamp((lightmap - 1.0 / 32.0) * 16.0 / 15.0, 0.0, 1.0);
    normal = normalize(mat3(gbufferModelViewInverse) * (gl_NormalMatrix * gl_Normal));

#if LAMPS_FORWARD
    player = (gbufferModelViewInverse * (gl_ModelViewMatrix * gl_Vertex)).xyz;
#endif

    int id = int(floor(mc_Entity.x + 0.5));
    bool thin = id == block_plant || id == block_leaves;
    material = block_emission(id, at_midBlock.w) + (thin ? material_thin : 0.0);
#if GLOSSY
    material += material_gloss * float(block_gloss(id));
#endif
#if defined PROGRAM_GLOW
    material = 5.0;  // bright, and not white whatever the colour
#endif
}

#else

in vec2 uv;
in vec4 tint;
in vec2 light;
flat in vec3 normal;
flat in float material;

#if LAMPS_FORWARD
#extension GL_ARB_shader_image_load_store : enable
#include "/include/lights/lit_by_lamps.glsl"

in vec3 player;
#endif

#if !defined PROGRAM_BASIC
uniform sampler2D gtexture;
#endif
#if defined PROGRAM_ENTITIES
uniform vec4 entityColor;
#endif

#if LAMPS_FORWARD
/* RENDERTARGETS: 1,2,7 */
layout(location = 2) out vec4 out_lamps;
#else
/* RENDERTARGETS: 1,2 */
#endif
layout(location = 0) out vec4 out_albedo;
layout(location = 1) out vec4 out_geometry;

void main() {
    // separateAo: the tint's alpha is ambient occlusion.
    vec4 color = vec4(tint.rgb, 1.0);
#if !defined PROGRAM_BASIC
    color *= texture(gtexture, uv);
    if (color.a < alphaTestRef) discard;
#endif
#if defined PROGRAM_GLOW || defined PROGRAM_ENTITIES
    if (tint.a < 0.3) discard;  // the veil around a beam, the board behind a name
#endif
#if defined PROGRAM_ENTITIES
    color.rgb = mix(color.rgb, entityColor.rgb, entityColor.a);
#endif
#if defined PROGRAM_GLOW
    color.rgb /= max(max(color.r, color.g), max(color.b, 0.01));
#endif
    out_albedo = vec4(color.rgb, material / 255.0);
#if LAMPS_FORWARD
    float thin = float(mod(material, material_gloss) >= material_thin);
    // As the G-buffer rounds them, so that the methods differ in their cost alone.
    vec3 albedo = to_linear(floor(clamp(color.rgb, 0.0, 1.0) * 255.0 + 0.5) / 255.0);
    vec3 n = decode_normal(encode_normal(normal));
    out_lamps = vec4(lamps_radiance(player, n, thin, albedo), 0.0);
#endif
    out_geometry = vec4(encode_normal(normal), occlude_light(light, tint.a));
}

#endif
