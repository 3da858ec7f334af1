#version 430 compatibility
// Puts these samples into the face cache, all at once.
#include "/program/face_cache/commit.glsl"
