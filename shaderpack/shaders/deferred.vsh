#version 330 compatibility
// Light from everything but the direct sun: rays through the voxels, averaged over frames.
#define VERTEX_STAGE
#include "/program/gi/gather.glsl"
