#version 330 compatibility
#define VERTEX_STAGE
#include "/program/d0_gi.glsl"
