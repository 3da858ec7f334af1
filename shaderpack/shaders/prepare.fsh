#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/floodfill/atlas_step.glsl"
