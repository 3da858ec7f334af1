#version 330 compatibility
// The same averaged over frames.
#define FRAGMENT_STAGE
#include "/program/gi/mean.glsl"
