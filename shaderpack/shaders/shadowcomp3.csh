#version 430 compatibility
#include "/program/s3_light_assign.glsl"
