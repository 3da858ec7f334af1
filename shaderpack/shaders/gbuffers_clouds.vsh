#version 330 compatibility
#define PROGRAM_CLOUDS
#define VERTEX_STAGE
#include "/program/gbuffers/translucent.glsl"
