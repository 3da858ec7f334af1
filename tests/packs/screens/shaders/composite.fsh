#version 330 compatibility
#define STEPS 4 // [2 4 8]
void main() {}
