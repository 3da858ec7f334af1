#version 430 compatibility
#include "/program/s0_lakes.glsl"
