#version 330 compatibility
/* RENDERTARGETS: 0,one */
void main() {}
