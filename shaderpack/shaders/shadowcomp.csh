#version 430 compatibility
// Which bricks hold other blocks than in the frame before.
#include "/program/voxels/changes.glsl"
