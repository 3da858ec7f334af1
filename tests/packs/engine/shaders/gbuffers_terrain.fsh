#version 330 compatibility

uniform sampler2D gtexture;

in vec2 uv;
in vec4 tint;
in float block;

/* RENDERTARGETS: 0 */
layout(location = 0) out vec4 color;

// Blocks that block.properties lists are blue.
void main() {
  color = texture(gtexture, uv) * tint;
  if (block > 0.5) color.rgb = vec3(0, 0, block / 10);
}
