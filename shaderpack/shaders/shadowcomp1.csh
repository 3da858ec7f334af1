#version 430 compatibility
#include "/program/s1_voxel_bits.glsl"
