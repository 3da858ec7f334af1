#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/d1_lighting.glsl"
