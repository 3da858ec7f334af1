#version 430 compatibility
#include "/program/s5_light_commit.glsl"
