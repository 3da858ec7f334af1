#version 330 compatibility
// The glint of what is enchanted, added to the albedo.
#define VERTEX_STAGE
#include "/program/gbuffers/damagedblock.glsl"
