#version 120
// Every name of old GLSL that a vertex stage has and core GLSL has not.
attribute vec4 mc_Entity;
varying vec3 normal;
varying float entity;
void main() {
  vec4 view = gl_ModelViewMatrix * gl_Vertex;
  vec4 back = gl_ModelViewMatrixInverse * view;
  vec4 clip = gl_ProjectionMatrix * view;
  vec4 again = gl_ProjectionMatrixInverse * clip;
  gl_Position = mix(ftransform(), gl_ModelViewProjectionMatrix * back, 0.5);
  gl_TexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;
  gl_TexCoord[1] = gl_TextureMatrix[1] * gl_MultiTexCoord1;
  gl_TexCoord[2] = gl_TextureMatrix[2] * gl_MultiTexCoord2 + gl_MultiTexCoord3 * 0.01 + gl_MultiTexCoord5;
  gl_FrontColor = gl_Color * gl_NormalScale;
  gl_FrontSecondaryColor = gl_SecondaryColor;
  gl_FogFragCoord = length(again.xyz / again.w) + gl_FogCoord;
  gl_ClipVertex = view;
  normal = normalize(gl_NormalMatrix * gl_Normal);
  entity = mc_Entity.x;
}
