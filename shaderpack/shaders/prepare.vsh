#version 330 compatibility
#define VERTEX_STAGE
#include "/program/p0_floodfill_step.glsl"
