#version 330 compatibility
// Leashes into the G-buffer: a colour without texture.
#define PROGRAM_BASIC
#define FRAGMENT_STAGE
#include "/program/gbuffers/opaque.glsl"
