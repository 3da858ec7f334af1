#version 430 compatibility
// Makes cells of these bricks ready whose blocks changed.
#include "/program/floodfill/image_cells.glsl"
