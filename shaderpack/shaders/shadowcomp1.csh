#version 430 compatibility
#include "/program/voxels/bits.glsl"
