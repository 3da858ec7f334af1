#version 120
uniform sampler2D texture;
uniform sampler2D lightmap;
varying vec3 normal;
varying float entity;
void main() {
  vec4 color = texture2D(texture, gl_TexCoord[0].st) * gl_Color + gl_SecondaryColor * 0.0;
  color.rgb *= texture2D(lightmap, gl_TexCoord[1].st).rgb * (0.6 + 0.4 * normal.z) + gl_TexCoord[2].rgb * 0.1;
  float fog = clamp((gl_Fog.end - gl_FogFragCoord) * gl_Fog.scale, 0.0, 1.0);
  color.rgb = mix(gl_Fog.color.rgb, color.rgb, fog) + gl_Fog.density + gl_Fog.start * 0.0001;
  gl_FragData[0] = color;
  // A return in the middle of main must not skip the alpha test.
  if (entity > 1.0e6) return;
  gl_FragData[0].rgb += 0.01;
}
