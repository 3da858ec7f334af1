#version 430 compatibility
#include "/program/s2_light_table.glsl"
