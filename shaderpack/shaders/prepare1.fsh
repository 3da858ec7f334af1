#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/p1_floodfill_keep.glsl"
