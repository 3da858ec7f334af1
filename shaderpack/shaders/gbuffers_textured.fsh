#version 330 compatibility
// Entities, particles and whatever has no program of its own into the G-buffer.
#define FRAGMENT_STAGE
#include "/program/gbuffers/opaque.glsl"
