#version 330 compatibility
// Beams that glow into the G-buffer, without the veil around them.
#define PROGRAM_GLOW
#define FRAGMENT_STAGE
#include "/program/gbuffers/opaque.glsl"
