#version 330 compatibility
// Light from everything but the direct sun: rays into the hemisphere.
#define VERTEX_STAGE
#include "/program/gi/rays.glsl"
