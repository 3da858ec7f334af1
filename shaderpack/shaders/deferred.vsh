#version 330 compatibility
#define VERTEX_STAGE
#include "/program/gi/gather.glsl"
