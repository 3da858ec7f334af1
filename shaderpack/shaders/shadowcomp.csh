#version 430 compatibility
#include "/program/s0_face_update.glsl"
