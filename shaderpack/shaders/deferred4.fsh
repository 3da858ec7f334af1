#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/lighting.glsl"
