#define TINT 0 // [0 1 2]

vec3 tinted(vec3 color) {
#if TINT == 1
  return color * vec3(1.0, 0.25, 0.25);
#elif TINT == 2
  return color * vec3(0.25, 0.25, 1.0);
#else
  return color;
#endif
}
