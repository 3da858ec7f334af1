// Textures are sRGB-like, light is linear.
#if !defined INCLUDED_MATH_COLOR
#define INCLUDED_MATH_COLOR

vec3 to_linear(vec3 color) { return pow(max(color, vec3(0.0)), vec3(2.2)); }

vec3 to_display(vec3 color) { return pow(max(color, vec3(0.0)), vec3(1.0 / 2.2)); }

float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }

#endif
