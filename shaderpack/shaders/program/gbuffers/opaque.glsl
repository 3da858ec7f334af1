// Opaque geometry into the G-buffer. PROGRAM_BASIC: without a texture. PROGRAM_GLOW: lightning, beams and eyes, which
// the game adds to the picture and which here glow. PROGRAM_ENTITIES: red when hurt.
#include "/settings.glsl"
#include "/include/block_vertex.glsl"
#include "/include/blocks.glsl"
#include "/include/gbuffer.glsl"
#include "/include/gi/ambient.glsl"

#if defined VERTEX_STAGE

flat out float material;
#if HAS_FORWARD_LAMPS
out vec3 player;
#endif

void main() {
    int id = place_vertex();
#if HAS_FORWARD_LAMPS
    player = (gbufferModelViewInverse * (gl_ModelViewMatrix * gl_Vertex)).xyz;
#endif
    bool thin = id == block_plant || id == block_leaves;
    material = block_emission(id, at_midBlock.w) + (thin ? material_thin : 0.0);
#if HAS_GLOSSY
    material += material_gloss * float(block_gloss(id));
#endif
#if defined PROGRAM_GLOW
    material = 5.0;  // bright, and not white whatever the colour
#endif
}

#else

flat in float material;

#if HAS_FORWARD_LAMPS
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

#if HAS_FORWARD_LAMPS
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
#if HAS_FORWARD_LAMPS
    float thin = float(mod(material, material_gloss) >= material_thin);
    // As the G-buffer rounds them, so that the methods differ in their cost alone.
    vec3 albedo = to_linear(floor(clamp(color.rgb, 0.0, 1.0) * 255.0 + 0.5) / 255.0);
    vec3 n = decode_normal(encode_normal(normal));
    out_lamps = vec4(lamps_radiance(player, n, thin, albedo), 0.0);
#endif
    out_geometry = vec4(encode_normal(normal), occlude_light(light, tint.a));
}

#endif
