#version 330 compatibility
// The outline of the selected block, blended over the albedo.
#define VERTEX_STAGE
#include "/program/gbuffers/line.glsl"
