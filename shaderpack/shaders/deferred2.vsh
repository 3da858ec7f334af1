#version 330 compatibility
// The same averaged over frames.
#define VERTEX_STAGE
#include "/program/gi/mean.glsl"
