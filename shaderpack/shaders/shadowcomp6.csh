#version 430 compatibility
#include "/program/voxels/distance.glsl"
