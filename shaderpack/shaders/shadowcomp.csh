#version 430 compatibility
#include "/program/s0_voxel_changes.glsl"
