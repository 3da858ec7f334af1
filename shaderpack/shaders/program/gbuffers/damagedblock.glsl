// Cracks of a block being broken, which the game multiplies onto the albedo, and the glint of what is
// enchanted, which it adds. Alpha 0 is the material byte of a plain block.
#if defined VERTEX_STAGE

out vec2 uv;

void main() {
    gl_Position = ftransform();
    uv = (gl_TextureMatrix[0] * gl_MultiTexCoord0).xy;
}

#else

in vec2 uv;

uniform sampler2D gtexture;
uniform float alphaTestRef;

/* RENDERTARGETS: 1 */
layout(location = 0) out vec4 out_albedo;

void main() {
    vec4 color = texture(gtexture, uv);
    if (color.a < alphaTestRef) discard;
    out_albedo = vec4(color.rgb, 0.0);
}

#endif
