#version 430 compatibility
#include "/program/floodfill/image_tint.glsl"
