#version 430 compatibility
// What table and clusters of the lamps are made for.
#include "/program/lights/commit.glsl"
