// Cameras for worlds that have none.
#pragma once

#include <optional>

#include <orris/world/world.h>

namespace orris {

/// From the south-west above, as near as the box's corners allow in a square picture.
Camera outsideCamera(const BlockWorld& blocks, const std::string& name);

/// Standing with its feet in `spot`, looking where the view is longest.
Camera standingCamera(const BlockWorld& blocks, glm::ivec3 spot, const std::string& name);

/// On the ground or the water at `column` (x, z), or at the nearest column where there is room to
/// stand. In the Nether under its roof. nullopt when there is no such place.
std::optional<Camera> surfaceCamera(const World& world, glm::ivec2 column);

}  // namespace orris
