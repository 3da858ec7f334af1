#version 330 compatibility
// Lightning into the G-buffer: a colour without texture, which glows.
#define PROGRAM_GLOW
#define PROGRAM_BASIC
#define VERTEX_STAGE
#include "/program/gbuffers/opaque.glsl"
