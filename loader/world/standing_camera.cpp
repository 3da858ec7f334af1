#include <orris/world/standing_camera.h>

#include <array>
#include <cstdlib>

#include <orris/world/blocks/block_facts.h>

namespace orris {
namespace {

constexpr float kStandingFov = 70;
constexpr double kStandingEye = 1.62;
constexpr int kNetherRoof = 120;     // blocks; bedrock lies above
constexpr int kFarthestColumn = 48;  // blocks from the one asked for

struct Heading {
  glm::ivec3 step;
  float yaw;
};
constexpr std::array<Heading, 4> kHeadings{
    {{{0, 0, 1}, 0}, {{-1, 0, 0}, 90}, {{0, 0, -1}, 180}, {{1, 0, 0}, 270}}};

/// What one may stand on and in, by palette index.
class Footing {
 public:
  explicit Footing(const World& world) : blocks_(world.blocks) {
    const BlockTable table;
    for (const BlockState& state : blocks_.palette()) {
      const BlockFacts facts = table.factsOf(state);
      constexpr unsigned kUpFace = 1u << int(FaceDirection::Up);
      ground_.push_back((facts.coveredFaces & kUpFace) != 0 || facts.fluid);
      room_.push_back(facts.air || facts.cross || (facts.boxes.empty() && !facts.fluid));
    }
  }

  /// The cell of the feet over the highest ground of a column below `top`.
  std::optional<glm::ivec3> over(glm::ivec2 column, int top) const {
    for (int y = top - 1; y >= blocks_.origin().y; --y) {
      const glm::ivec3 feet(column.x, y + 1, column.y);
      if (!ground_[blocks_.indexAt(feet - glm::ivec3(0, 1, 0))]) continue;
      const bool fits =
          room_[blocks_.indexAt(feet)] && room_[blocks_.indexAt(feet + glm::ivec3(0, 1, 0))];
      if (fits) return feet;
    }
    return std::nullopt;
  }

 private:
  const BlockWorld& blocks_;
  std::vector<bool> ground_, room_;
};

}  // namespace

Camera standingCamera(const BlockWorld& blocks, glm::ivec3 spot, const std::string& name) {
  const auto isFree = [&](glm::ivec3 p) { return blocks.contains(p) && blocks.indexAt(p) == 0; };
  Camera camera{name, glm::dvec3(spot) + glm::dvec3(0.5, kStandingEye, 0.5), 0, 0, kStandingFov};
  int longest = -1;
  for (const Heading& heading : kHeadings) {
    int length = 0;
    glm::ivec3 p = spot + glm::ivec3(0, 1, 0);
    while (isFree(p += heading.step)) ++length;
    if (length <= longest) continue;
    longest = length;
    camera.yaw = heading.yaw;
  }
  return camera;
}

std::optional<Camera> surfaceCamera(const World& world, glm::ivec2 column) {
  const Footing footing(world);
  const int end = world.blocks.origin().y + world.blocks.size().y;
  const int top =
      world.environment.dimension == "minecraft:the_nether" ? std::min(end, kNetherRoof) : end;
  for (int ring = 0; ring <= kFarthestColumn; ++ring) {
    for (int z = -ring; z <= ring; ++z) {
      const int step = std::abs(z) == ring ? 1 : std::max(1, 2 * ring);
      for (int x = -ring; x <= ring; x += step) {
        if (const auto feet = footing.over(column + glm::ivec2(x, z), top))
          return standingCamera(world.blocks, *feet, "surface");
      }
    }
  }
  return std::nullopt;
}

}  // namespace orris
