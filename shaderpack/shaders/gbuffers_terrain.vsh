#version 330 compatibility
// Terrain into the G-buffer: albedo, material, normal, lightmap.
#define VERTEX_STAGE
#include "/program/gbuffers/opaque.glsl"
