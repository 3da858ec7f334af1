#version 330 compatibility
#include "../../secret.glsl"
void main() {}
