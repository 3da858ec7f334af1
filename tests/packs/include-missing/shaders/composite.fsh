#version 330 compatibility
#include "/lib/outer.glsl"
void main() {}
