#version 330 compatibility
/* RENDERTARGETS: 0,32 */
void main() {}
