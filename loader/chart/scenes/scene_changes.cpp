#include <orris/chart/scenes/scene_changes.h>

#include <cmath>
#include <string>

namespace orris {
namespace {

/// Before the eye's feet: out of its sight as a rule.
glm::ivec3 footCell(const Camera& camera) { return glm::ivec3(glm::floor(camera.position)) - glm::ivec3(0, 1, 0); }

BlockState stateNamed(const char* name) { return {std::string("minecraft:") + name, {}}; }

}  // namespace

World withLamp(const World& world, const Camera& camera, int frame) {
  World changed = world;
  const glm::ivec3 cell = footCell(camera) + glm::ivec3(0, 2, 0);
  changed.events = {{frame, SetBlock{cell, stateNamed("glowstone")}}};
  changed.blocks.paletteIndex(stateNamed("glowstone"));
  return changed;
}

World withEdits(const World& world, const Camera& camera, int frames) {
  World changed = world;
  const glm::ivec3 cell = footCell(camera);
  const BlockState usual = world.blocks.at(cell);
  changed.blocks.paletteIndex(stateNamed("stone"));
  changed.events.clear();
  for (int frame = 1; frame < frames; ++frame)
    changed.events.push_back({frame, SetBlock{cell, frame % 2 == 1 ? stateNamed("stone") : usual}});
  return changed;
}

World withMotion(const World& world, const Camera& camera, int frames) {
  constexpr double kRadius = 0.5, kStep = 4.3 / 60;  // blocks
  World changed = world;
  changed.events.clear();
  for (int frame = 1; frame < frames; ++frame) {
    Camera moved = camera;
    const double angle = frame * kStep / kRadius;
    moved.position += kRadius * glm::dvec3(std::cos(angle), 0, std::sin(angle));
    changed.events.push_back({frame, MoveCamera{moved}});
  }
  return changed;
}

World withoutEvents(const World& world) {
  World still = world;
  still.events.clear();
  return still;
}

}  // namespace orris
