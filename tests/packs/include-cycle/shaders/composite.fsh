#version 330 compatibility
#include "lib/a.glsl"
void main() {}
