#version 330 compatibility
#define PROGRAM_BASIC
#define FRAGMENT_STAGE
#include "/program/gbuffers/opaque.glsl"
