#include <orris/world/terrain.h>

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

constexpr int kPlot = 7;        // trees stand at most one a plot
constexpr int kTreeMargin = 3;  // from the box's sides, so that crowns are whole
constexpr int kTreeRoom = 8;    // blocks above the ground
constexpr int kSoil = 3;
constexpr int kOctaves = 4;
constexpr double kLargestHill = 40;  // blocks, wave length of the first octave

/// A well-mixed 32 bit value of its arguments (the finaliser of MurmurHash3 after each).
std::uint32_t hash(std::uint32_t seed, int a, int b) {
  std::uint32_t h = seed;
  for (const std::uint32_t part : {std::uint32_t(a), std::uint32_t(b)}) {
    h = (h ^ part) + 0x9e3779b9u;
    h ^= h >> 16;
    h *= 0x85ebca6bu;
    h ^= h >> 13;
    h *= 0xc2b2ae35u;
    h ^= h >> 16;
  }
  return h;
}

double unitHash(std::uint32_t seed, int a, int b) { return hash(seed, a, b) / 4294967296.0; }

/// Value noise 0..1 with smooth interpolation.
double noise(std::uint32_t seed, double x, double z) {
  const double x0 = std::floor(x), z0 = std::floor(z);
  const double s = x - x0, t = z - z0;
  const double u = s * s * (3 - 2 * s), v = t * t * (3 - 2 * t);
  const int i = int(x0), k = int(z0);
  const double north = unitHash(seed, i, k) * (1 - u) + unitHash(seed, i + 1, k) * u;
  const double south = unitHash(seed, i, k + 1) * (1 - u) + unitHash(seed, i + 1, k + 1) * u;
  return north * (1 - v) + south * v;
}

class TerrainGenerator {
 public:
  TerrainGenerator(BlockWorld& world, const TerrainSettings& settings)
      : world_(world), settings_(settings), low_(world.origin()), size_(world.size()), sea_(settings.seaLevel - low_.y) {}

  void run() {
    for (int z = 0; z < size_.z; ++z) {
      for (int x = 0; x < size_.x; ++x) addColumn(x, z);
    }
    for (int z = 0; z < size_.z; z += kPlot) {
      for (int x = 0; x < size_.x; x += kPlot) addTree(x, z);
    }
  }

 private:
  std::uint32_t block(const char* name) {
    return world_.paletteIndex({std::string("minecraft:") + name, {}});
  }

  /// Height of the ground block, 1 .. top of the box.
  int ground(int x, int z) const {
    double sum = 0, weights = 0, weight = 1, scale = 1 / kLargestHill;
    for (int octave = 0; octave < kOctaves; ++octave) {
      const double value =
          noise(settings_.seed + std::uint32_t(octave), (x + low_.x) * scale, (z + low_.z) * scale);
      sum += weight * value;
      weights += weight;
      weight *= 0.45;
      scale *= 2;
    }
    const double height = sea_ + settings_.relief * (2.4 * sum / weights - 1.05);
    return std::clamp(int(std::floor(height)), 1, std::max(1, size_.y - 1));
  }

  bool isGrass(int height) const { return height > sea_ + 1; }

  void addColumn(int x, int z) {
    const int height = ground(x, z);
    const glm::ivec3 p = low_ + glm::ivec3(x, 0, z);
    const auto at = [&](int y) { return p + glm::ivec3(0, y, 0); };
    world_.fill(at(0), at(size_.y - 1), 0);
    world_.fill(at(0), at(height), stone_);
    world_.fill(at(std::max(0, height - kSoil)), at(height), isGrass(height) ? dirt_ : sand_);
    if (isGrass(height)) world_.set(at(height), grass_);
    if (height < sea_) world_.fill(at(height + 1), at(sea_), water_);
    if (isGrass(height) && unitHash(settings_.seed + 101, p.x, p.z) < settings_.plants) {
      world_.set(at(height + 1), plants_[hash(settings_.seed + 102, p.x, p.z) % 3]);
    }
  }

  void addTree(int plotX, int plotZ) {
    const std::uint32_t random = hash(settings_.seed + 103, plotX + low_.x, plotZ + low_.z);
    if (unitHash(settings_.seed + 104, plotX + low_.x, plotZ + low_.z) >= settings_.trees) return;
    const int x = plotX + int(random % kPlot), z = plotZ + int(random / kPlot % kPlot);
    if (std::min(x, z) < kTreeMargin || x >= size_.x - kTreeMargin || z >= size_.z - kTreeMargin) {
      return;
    }
    const int height = ground(x, z);
    if (!isGrass(height) || height + kTreeRoom >= size_.y) return;
    const glm::ivec3 root = low_ + glm::ivec3(x, height, z);
    const int trunk = 4 + int(random / 49 % 3);
    addCrown(root + glm::ivec3(0, trunk, 0));
    world_.set(root, dirt_);
    world_.fill(root + glm::ivec3(0, 1, 0), root + glm::ivec3(0, trunk, 0), log_);
  }

  /// Two wide layers of leaves below two narrow ones around the trunk's end.
  void addCrown(glm::ivec3 top) {
    for (int dy = -2; dy <= 1; ++dy) {
      const int radius = dy < 0 ? 2 : 1;
      for (int dz = -radius; dz <= radius; ++dz) {
        for (int dx = -radius; dx <= radius; ++dx) {
          const bool corner = std::abs(dx) == radius && std::abs(dz) == radius;
          const glm::ivec3 p = top + glm::ivec3(dx, dy, dz);
          if ((corner && dy != -2) || isGround(p)) continue;
          world_.set(p, leaves_);
        }
      }
    }
  }

  bool isGround(glm::ivec3 p) const {
    const std::uint32_t index = world_.indexAt(p);
    return index == grass_ || index == dirt_ || index == stone_ || index == log_;
  }

  BlockWorld& world_;
  const TerrainSettings& settings_;
  const glm::ivec3 low_, size_;
  const int sea_;  // above the box's lowest block, as every height here
  const std::uint32_t stone_ = block("stone"), dirt_ = block("dirt"), grass_ = block("grass_block"),
                      sand_ = block("sand"), water_ = block("water"), log_ = block("oak_log"),
                      leaves_ = block("oak_leaves");
  const std::uint32_t plants_[3] = {block("fern"), block("dandelion"), block("poppy")};
};

}  // namespace

void generateTerrain(BlockWorld& world, const TerrainSettings& settings) {
  TerrainGenerator(world, settings).run();
}

}  // namespace orris
