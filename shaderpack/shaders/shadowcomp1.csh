#version 430 compatibility
// Which cells hold something, a bit each, after a change; for RAY_WALK=DISTANCE.
#include "/program/voxels/bits.glsl"
