#version 430 compatibility
#include "/program/voxels/lakes.glsl"
