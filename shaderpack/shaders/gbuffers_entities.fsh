#version 330 compatibility
// Entities into the G-buffer, red when hurt.
#define PROGRAM_ENTITIES
#define FRAGMENT_STAGE
#include "/program/gbuffers/opaque.glsl"
