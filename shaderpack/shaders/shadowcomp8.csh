#version 430 compatibility
#include "/program/s8_face_commit.glsl"
