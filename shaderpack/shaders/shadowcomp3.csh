#version 430 compatibility
// The table of the lamps, sorted by place.
#include "/program/lights/table.glsl"
