#version 330 compatibility
// The outline of the selected block, blended over the albedo.
#define FRAGMENT_STAGE
#include "/program/gbuffers/line.glsl"
