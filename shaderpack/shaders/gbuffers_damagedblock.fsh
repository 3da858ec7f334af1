#version 330 compatibility
// Cracks of a block being broken, multiplied onto the albedo.
#define FRAGMENT_STAGE
#include "/program/gbuffers/damagedblock.glsl"
