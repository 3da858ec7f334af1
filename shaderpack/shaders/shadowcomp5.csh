#version 430 compatibility
#include "/program/lights/commit.glsl"
