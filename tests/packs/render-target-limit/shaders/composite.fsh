#version 330 compatibility
/* RENDERTARGETS: 0,16 */
void main() {}
