//#define BLOOM
#define STEPS 8 // [2 4 8]
