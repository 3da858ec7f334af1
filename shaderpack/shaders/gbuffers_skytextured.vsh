#version 330 compatibility
#define PROGRAM_TEXTURED
#define VERTEX_STAGE
#include "/program/gbuffers/sky.glsl"
