#version 430 compatibility
// The lamps that reach each cluster, as sorted lists.
#include "/program/lights/lists.glsl"
