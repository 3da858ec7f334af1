#version 330 compatibility
// The same by rays to lamps.
#define VERTEX_STAGE
#define RAYS_TO_LAMPS
#include "/program/gi/rays.glsl"
