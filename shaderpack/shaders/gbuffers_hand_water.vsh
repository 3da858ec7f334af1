#version 330 compatibility
// Translucent things in the hand, lit where they are drawn.
#define VERTEX_STAGE
#include "/program/gbuffers/translucent.glsl"
