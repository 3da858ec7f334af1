#version 330 compatibility
// Sun and moon.
#define PROGRAM_TEXTURED
#define VERTEX_STAGE
#include "/program/gbuffers/sky.glsl"
