#version 330 compatibility
// The exposure that the picture asks for.
#define FRAGMENT_STAGE
#include "/program/post/exposure.glsl"
