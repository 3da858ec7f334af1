#version 330 compatibility
// The same by rays to lamps.
#define FRAGMENT_STAGE
#define RAYS_TO_LAMPS
#include "/program/gi/rays.glsl"
