#version 330 compatibility
// Clouds, lit where they are drawn.
#define PROGRAM_CLOUDS
#define FRAGMENT_STAGE
#include "/program/gbuffers/translucent.glsl"
