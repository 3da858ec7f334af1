#version 330 compatibility
#define VERTEX_STAGE
#include "/program/d4_lighting.glsl"
