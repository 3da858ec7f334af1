#version 430 compatibility
#include "/program/lights/table.glsl"
