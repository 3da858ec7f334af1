#version 330 compatibility
#define VERTEX_STAGE
#include "/program/gbuffers/sky.glsl"
