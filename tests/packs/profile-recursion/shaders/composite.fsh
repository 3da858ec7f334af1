#version 330 compatibility
#define SSAO
#define SHADOW_Q 2 // [1 2 3]
#ifdef SSAO
#endif
void main() {}
