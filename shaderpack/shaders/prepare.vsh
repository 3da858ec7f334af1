#version 330 compatibility
#define VERTEX_STAGE
#include "/program/floodfill/atlas_step.glsl"
