#ifdef NEVER
  #include "colour.glsl"
#endif
// #include "ignored.glsl"
