#version 330 compatibility
/* RENDERTARGETS: 8 */
void main() {}
