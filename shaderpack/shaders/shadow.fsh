#version 330 compatibility
// Terrain into the shadow map, its blocks into the voxel atlas, its lamps into a list.
#define FRAGMENT_STAGE
#include "/program/shadow/shadow.glsl"
