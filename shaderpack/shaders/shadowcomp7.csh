#version 430 compatibility
#include "/program/s7_face_update.glsl"
