#version 430 compatibility
#include "/program/voxels/changes.glsl"
