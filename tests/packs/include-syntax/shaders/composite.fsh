#version 330 compatibility
#include "/lib/a.glsl" // the sky
#include
void main() {}
