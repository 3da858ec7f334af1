#version 330 compatibility
// Water and glass, lit where they are drawn.
#define VERTEX_STAGE
#include "/program/gbuffers/translucent.glsl"
