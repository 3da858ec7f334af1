#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/d0_gi.glsl"
