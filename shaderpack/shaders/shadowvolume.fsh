#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/shadowvolume.glsl"
