#version 330 compatibility
// Terrain into the G-buffer: albedo, material, normal, lightmap.
#define FRAGMENT_STAGE
#include "/program/gbuffers/opaque.glsl"
