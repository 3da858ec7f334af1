#version 430 compatibility
#include "/program/s1_face_commit.glsl"
