// What a vertex of the world gives its pixels, whatever program draws it.
#if !defined INCLUDED_BLOCK_VERTEX
#define INCLUDED_BLOCK_VERTEX

#include "/include/uniforms.glsl"

#if defined VERTEX_STAGE

in vec2 mc_Entity;
in vec4 at_midBlock;

out vec2 uv;
out vec4 tint;
out vec2 light;        // levels of lamps and sky, 0..1
flat out vec3 normal;  // world axes

/// Writes them, and where the vertex is on the screen. Returns the block's id (include/blocks.glsl).
int place_vertex() {
    gl_Position = ftransform();
    uv = (gl_TextureMatrix[0] * gl_MultiTexCoord0).xy;
    tint = gl_Color;
    // Texture coordinates of the lightmap back to levels.
    vec2 lightmap = (gl_TextureMatrix[1] * gl_MultiTexCoord1).xy;
    light = clamp((lightmap - 1.0 / 32.0) * 16.0 / 15.0, 0.0, 1.0);
    normal = normalize(mat3(gbufferModelViewInverse) * (gl_NormalMatrix * gl_Normal));
    return int(floor(mc_Entity.x + 0.5));
}

#else

in vec2 uv;
in vec4 tint;
in vec2 light;
flat in vec3 normal;

#endif

#endif
