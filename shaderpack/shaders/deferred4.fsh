#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/d4_lighting.glsl"
