#version 430 compatibility
#include "/program/p2_floodfill_tint.glsl"
