#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/p0_floodfill_step.glsl"
