// A world of few blocks for tests of what a scene holds.
#pragma once

#include <orris/world/world.h>

namespace orris {

/// A floor of 16 x 16 blocks with lamps on it, eight a row from (-4, -4), seen from above.
inline World lampFloor(int count, const char* lamp = "minecraft:sea_lantern") {
  World world;
  world.blocks = BlockWorld({-8, 0, -8}, {16, 4, 16});
  const auto stone = world.blocks.paletteIndex(*parseBlockState("minecraft:stone"));
  world.blocks.fill({-8, 0, -8}, {7, 0, 7}, stone);
  const auto block = world.blocks.paletteIndex(*parseBlockState(lamp));
  for (int i = 0; i < count; ++i) world.blocks.set({i % 8 - 4, 1, i / 8 - 4}, block);
  Camera camera;
  camera.position = {0.5, 5.5, 0.5};
  camera.pitch = 90;
  world.cameras = {camera};
  return world;
}

}  // namespace orris
