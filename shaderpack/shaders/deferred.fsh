#version 330 compatibility
// Light from everything but the direct sun: rays into the hemisphere.
#define FRAGMENT_STAGE
#include "/program/gi/rays.glsl"
