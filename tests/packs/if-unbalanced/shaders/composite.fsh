#version 330 compatibility
#include "lib/open.glsl"
void main() {}
