#version 330 compatibility
// Stars.
#define FRAGMENT_STAGE
#include "/program/gbuffers/sky.glsl"
