#version 330 compatibility
// The glint of what is enchanted, added to the albedo.
#define FRAGMENT_STAGE
#include "/program/gbuffers/damagedblock.glsl"
