#version 330 compatibility
#include "/lib/buffers.glsl"
void main() {}
