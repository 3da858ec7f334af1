#version 330 compatibility
//#define BLOOM
#ifdef BLOOM
#endif
#error never seen either
void main() {}
