#version 330 compatibility
// Eyes that glow into the G-buffer.
#define PROGRAM_GLOW
#define VERTEX_STAGE
#include "/program/gbuffers/opaque.glsl"
