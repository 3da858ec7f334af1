#define BLOOM // glow
#define STEPS 4 // [2 4 8]
