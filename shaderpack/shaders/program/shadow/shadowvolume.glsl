// Counts shadow volumes: only their places matter, the host counts fragments in the stencil.
#if defined VERTEX_STAGE

void main() { gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }

#else

void main() {}

#endif
