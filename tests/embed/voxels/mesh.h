/* The voxel engine's own mesh: a buffer for each chunk and kind of geometry. */
#ifndef VOXELS_MESH_H
#define VOXELS_MESH_H

#include <orris/orris.h>

#include "terrain.h"

enum { LAYERS = 3 };

/** A chunk's quads of one kind, or none. */
typedef struct Layer {
  unsigned buffer;
  unsigned vertices;
} Layer;

typedef struct Chunk {
  int x, z; /* first block */
  Layer layers[LAYERS];
} Chunk;

/** What of a pack changes the vertices. */
typedef struct MeshStyle {
  int ids[BLOCK_COUNT]; /* of block.properties */
  int separate_ao;
} MeshStyle;

extern const OrrisKind layer_kinds[LAYERS];
extern const char* const block_states[BLOCK_COUNT];

/** Meshes a chunk into buffers of its own, made when they are needed. 0: no memory. */
int mesh_chunk(Chunk* chunk, const MeshStyle* style);

/** A cube of half a block around 0 with one colour, four vertices to each of six faces. */
void fill_cube(OrrisVertex vertices[24], const unsigned char color[3]);

/** GL name of the texture: BLOCK_COUNT tiles of 16x16 side by side. */
unsigned make_textures(void);

#endif
