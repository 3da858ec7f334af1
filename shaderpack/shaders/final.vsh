#version 330 compatibility
// Exposure and tone map: radiance to the screen.
#define VERTEX_STAGE
#include "/program/post/final.glsl"
