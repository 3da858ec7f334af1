#version 430 compatibility
#include "/program/lights/assign.glsl"
