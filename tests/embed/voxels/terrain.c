#include "terrain.h"

#include <math.h>

enum { SIZE = CHUNK * CHUNKS };
static unsigned char blocks[SIZE][HEIGHT][SIZE];

Block block_at(int x, int y, int z) {
  if (x < 0 || y < 0 || z < 0 || x >= SIZE || y >= HEIGHT || z >= SIZE) return AIR;
  return (Block)blocks[x][y][z];
}

static void put(int x, int y, int z, Block block) {
  if (x >= 0 && y >= 0 && z >= 0 && x < SIZE && y < HEIGHT && z < SIZE && blocks[x][y][z] == AIR)
    blocks[x][y][z] = (unsigned char)block;
}

int ground_at(int x, int z) {
  return SEA + (int)(4.5 * sin(x * 0.11) * cos(z * 0.09) + 3.0 * sin(x * 0.05 + z * 0.07 + 1.0) + 1.5);
}

static void grow_tree(int x, int z) {
  int dx, dy, dz, top = ground_at(x, z) + 5;
  for (dy = -4; dy < 0; ++dy) put(x, top + dy, z, LOG);
  for (dx = -2; dx <= 2; ++dx)
    for (dz = -2; dz <= 2; ++dz)
      for (dy = -2; dy <= 1; ++dy)
        if (dx * dx + dz * dz + dy * dy <= 5) put(x + dx, top + dy, z + dz, LEAVES);
}

void make_terrain(void) {
  int x, y, z;
  for (x = 0; x < SIZE; ++x)
    for (z = 0; z < SIZE; ++z) {
      const int height = ground_at(x, z);
      for (y = 0; y < height; ++y) put(x, y, z, STONE);
      put(x, height, z, height <= SEA ? SAND : GRASS);
      for (y = height + 1; y <= SEA; ++y) put(x, y, z, WATER);
    }
  for (x = 7; x < SIZE; x += 13)
    for (z = 5; z < SIZE; z += 11)
      if (ground_at(x, z) > SEA + 1) grow_tree(x, z);
  for (x = 12; x < SIZE; x += 24) put(x, ground_at(x, 40) + 1, 40, LAMP);
}
