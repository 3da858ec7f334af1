#version 430 compatibility
#include "/program/p1_floodfill_cells.glsl"
