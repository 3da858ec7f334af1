#version 330 compatibility
#define VERTEX_STAGE
#include "/program/p1_floodfill_keep.glsl"
