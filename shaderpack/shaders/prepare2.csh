#version 430 compatibility
// A step of the floodfill over the listed bricks of its image.
#include "/program/floodfill/image_step.glsl"
