// A scene with what changes while a setting is measured in it. All replace the world's own events.
#pragma once

#include <orris/world/world.h>

namespace orris {

/// The world with a lamp placed above the eye before `frame`.
World withLamp(const World& world, const Camera& camera, int frame);

/// The world with a block that comes and goes, in every frame.
World withEdits(const World& world, const Camera& camera, int frames);

/// The world in which the camera walks around its place in a circle of one block, as fast as the game's player (4.3 blocks a
/// second at 60 frames), and looks the same way: close to where the setting is judged, and over edges of blocks.
World withMotion(const World& world, const Camera& camera, int frames);

World withoutEvents(const World& world);

}  // namespace orris
