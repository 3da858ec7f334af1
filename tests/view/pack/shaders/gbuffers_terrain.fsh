#version 120
uniform sampler2D gtexture;
varying vec2 uv;
varying vec4 tint;
/* RENDERTARGETS: 0 */
void main() {
  gl_FragData[0] = texture2D(gtexture, uv) * tint;
}
