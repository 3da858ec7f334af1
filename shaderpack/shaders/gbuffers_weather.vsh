#version 330 compatibility
// Rain and snow, lit where they are drawn.
#define PROGRAM_WEATHER
#define VERTEX_STAGE
#include "/program/gbuffers/translucent.glsl"
