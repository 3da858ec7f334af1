#version 430 compatibility
// A sample of the light on a share of the exposed faces.
#include "/program/face_cache/update.glsl"
