#version 430 compatibility
// Lists the bricks that the step of the floodfill's image has to compute.
#include "/program/floodfill/image_list.glsl"
