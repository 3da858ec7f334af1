#version 330 compatibility
#define FRAGMENT_STAGE
#include "/program/shadow/shadow.glsl"
