#version 330 compatibility
#define PROGRAM_BASIC
#define VERTEX_STAGE
#include "/program/gbuffers/opaque.glsl"
