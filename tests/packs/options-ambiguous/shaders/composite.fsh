#version 330 compatibility
#include "/lib/a.glsl"
#include "/lib/b.glsl"
#ifdef BLOOM
#endif
void main() {}
