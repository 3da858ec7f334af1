#version 330 compatibility
#define GEOMETRY_STAGE
#include "/program/shadow/shadow.glsl"
