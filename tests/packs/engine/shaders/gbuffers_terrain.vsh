#version 330 compatibility

in vec2 mc_Entity;

out vec2 uv;
out vec4 tint;
out float block;

void main() {
  gl_Position = ftransform();
  uv = (gl_TextureMatrix[0] * gl_MultiTexCoord0).xy;
  tint = gl_Color;
  block = mc_Entity.x;
}
