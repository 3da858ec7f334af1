#version 330 compatibility

uniform int entityId;
uniform vec4 entityColor;

in vec4 tint;

/* RENDERTARGETS: 0 */
layout(location = 0) out vec4 color;

// The listed entity is red, another shows its colour; a hurt one takes that over.
void main() {
  color = entityId == 5 ? vec4(1, 0, 0, 1) : tint;
  color.rgb = mix(color.rgb, entityColor.rgb, entityColor.a);
}
