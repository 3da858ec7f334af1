#version 120
#include "/lib/tint.glsl"
uniform sampler2D colortex0;
varying vec2 uv;
/* RENDERTARGETS: 0 */
void main() {
  gl_FragData[0] = vec4(tinted(texture2D(colortex0, uv).rgb), 1.0);
}
