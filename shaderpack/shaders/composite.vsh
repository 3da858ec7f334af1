#version 330 compatibility
// The exposure that the picture asks for.
#define VERTEX_STAGE
#include "/program/post/exposure.glsl"
