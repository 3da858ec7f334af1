#version 430 compatibility
// Fills lakes: water below a surface of water has no faces of its own.
#include "/program/voxels/lakes.glsl"
