#version 430 compatibility
#include "/program/p3_floodfill_commit.glsl"
