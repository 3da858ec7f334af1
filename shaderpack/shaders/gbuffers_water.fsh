#version 330 compatibility
// Water and glass, lit where they are drawn.
#define FRAGMENT_STAGE
#include "/program/gbuffers/translucent.glsl"
