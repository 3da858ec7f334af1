#version 430 compatibility
#include "/program/lights/lists.glsl"
