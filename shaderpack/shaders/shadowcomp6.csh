#version 430 compatibility
#include "/program/s6_voxel_distance.glsl"
