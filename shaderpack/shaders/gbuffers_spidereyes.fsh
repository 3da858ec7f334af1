#version 330 compatibility
// Eyes that glow into the G-buffer.
#define PROGRAM_GLOW
#define FRAGMENT_STAGE
#include "/program/gbuffers/opaque.glsl"
