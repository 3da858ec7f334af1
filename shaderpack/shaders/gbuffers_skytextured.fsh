#version 330 compatibility
#define PROGRAM_TEXTURED
#define FRAGMENT_STAGE
#include "/program/gbuffers/sky.glsl"
