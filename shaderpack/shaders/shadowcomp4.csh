#version 430 compatibility
// The lamps that reach each cluster, as bits.
#include "/program/lights/assign.glsl"
