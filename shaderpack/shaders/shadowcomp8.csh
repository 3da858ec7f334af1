#version 430 compatibility
#include "/program/face_cache/commit.glsl"
