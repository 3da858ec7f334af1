#version 330 compatibility
// Leashes into the G-buffer: a colour without texture.
#define PROGRAM_BASIC
#define VERTEX_STAGE
#include "/program/gbuffers/opaque.glsl"
