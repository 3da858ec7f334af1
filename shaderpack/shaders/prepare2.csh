#version 430 compatibility
#include "/program/p2_floodfill_step.glsl"
