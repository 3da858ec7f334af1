#version 330 compatibility
// Exposure and tone map: radiance to the screen.
#define FRAGMENT_STAGE
#include "/program/post/final.glsl"
