#version 330 compatibility

#define BRIGHTNESS 1.0 // [0.5 1.0]
//#define SHOW_SHADOW // the shadow map in place of the picture

uniform sampler2D colortex0;
uniform sampler2D shadowtex0;
uniform int heldItemId;
uniform int isEyeInWater;
uniform int currentSelectedBlockId;
uniform vec3 currentSelectedBlockPos;
uniform vec4 lightningBoltPosition;
uniform float currentPlayerHealth;

in vec2 uv;

/* RENDERTARGETS: 0 */
layout(location = 0) out vec4 color;

void main() {
  color = texture(colortex0, uv) * BRIGHTNESS;
#ifdef SHOW_SHADOW
  color = vec4(texture(shadowtex0, uv).r);
#endif
  if (heldItemId == 3) color.g = 1.0;
  if (isEyeInWater == 1) color.b = 1.0;
  if (currentSelectedBlockId == 7) color.r = -currentSelectedBlockPos.z / 10.0;
  if (currentPlayerHealth >= 0.0) color.rgb = vec3(currentPlayerHealth);
  if (lightningBoltPosition.w > 0.5) color.rgb = lightningBoltPosition.yyy / 10.0;
}
