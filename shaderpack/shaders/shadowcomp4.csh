#version 430 compatibility
#include "/program/s4_light_lists.glsl"
