/* The voxel engine's own world: heights of hills from a sum of sines, lakes between them, a few trees. Nothing
 * of it comes from Orris. */
#ifndef VOXELS_TERRAIN_H
#define VOXELS_TERRAIN_H

enum { CHUNK = 16, HEIGHT = 48, CHUNKS = 6, SEA = 20 };

typedef enum Block { AIR, STONE, GRASS, SAND, LOG, LEAVES, WATER, LAMP, BLOCK_COUNT } Block;

/** Of the whole world; AIR outside of it. */
Block block_at(int x, int y, int z);

/** Height of the highest block of the ground. */
int ground_at(int x, int z);

/** Fills the world. */
void make_terrain(void);

#endif
