#version 430 compatibility
// The distance of each cell to the next block, after a change; for RAY_WALK=DISTANCE.
#include "/program/voxels/distance.glsl"
