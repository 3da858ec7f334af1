#version 330 compatibility
// A step of the floodfill over its atlas.
#define VERTEX_STAGE
#include "/program/floodfill/atlas_step.glsl"
