#version 330 compatibility
// Counts shadow volumes in the stencil.
#define VERTEX_STAGE
#include "/program/shadow/shadowvolume.glsl"
