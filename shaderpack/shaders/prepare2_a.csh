#version 430 compatibility
// Gives the stepped cells of glass and water their colour.
#include "/program/floodfill/image_tint.glsl"
