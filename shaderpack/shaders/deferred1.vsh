#version 330 compatibility
#define VERTEX_STAGE
#include "/program/d1_lighting.glsl"
