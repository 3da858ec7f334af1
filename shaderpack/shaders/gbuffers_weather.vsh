#version 330 compatibility
#define PROGRAM_WEATHER
#define VERTEX_STAGE
#include "/program/gbuffers/translucent.glsl"
