#version 330 compatibility
// Stars.
#define VERTEX_STAGE
#include "/program/gbuffers/sky.glsl"
