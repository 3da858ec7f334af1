#version 330 compatibility
/* DRAWBUFFERS:022 */
void main() {}
