// The faces that give light, and how one of them is drawn at random for a place that receives it.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include <orris/trace/grid/ray.h>

namespace orris {

/// One face of a lamp; its front gives `radiance`. Or a ball, which is no obstacle and is not met.
struct LampFace {
  std::uint32_t quad = 0;
  float radius = 0;                                    ///< of a ball about `corner`; 0: a face
  glm::vec3 corner{0}, edgeU{0}, edgeV{0}, normal{0};  ///< grid space
  glm::vec3 radiance{0};
  float area = 1;
  glm::ivec3 cell{0};  ///< of its block
};

/// A face drawn, and how probable that was.
struct LampDraw {
  const LampFace* face = nullptr;  ///< nullptr: no lamp shines here
  float probability = 0;
};

/// Space is divided into bricks. Each has a short list of the lamps that may matter most in it, by
/// power over squared distance, without those that turn their backs; the rest is drawn by power.
class LampSet {
 public:
  LampSet() = default;
  LampSet(std::vector<LampFace> faces, glm::ivec3 gridSize);
  bool empty() const { return faces_.empty(); }
  const LampFace& face(std::uint32_t index) const { return faces_[index]; }
  const std::vector<LampFace>& faces() const { return faces_; }
  /// For a place in this cell; `u` 0..1.
  LampDraw draw(glm::ivec3 cell, float u) const;
  /// Of drawing this face there.
  float probability(glm::ivec3 cell, std::uint32_t face) const;

 private:
  static constexpr std::size_t kListed = 48;
  /// Probability of its own, and of Walker's alias method: `keep` of an even share stays here, the
  /// rest goes to entry `other`.
  struct Entry {
    std::uint32_t face = 0;
    float probability = 0, keep = 1;
    std::uint32_t other = 0;
  };
  /// Entries [first, first + count), sorted by face; what is left of 1 is drawn by power.
  struct Brick {
    std::uint32_t first = 0, count = 0;
    float listed = 0;
  };
  const Brick& brickOf(glm::ivec3 cell) const;
  void list(glm::vec3 low, glm::vec3 high);
  void makeAliases(const Brick& brick);

  std::vector<LampFace> faces_;
  std::vector<float> power_, cumulative_;  ///< by face, normalised
  int edge_ = 4;                           ///< of a brick, cells: a power of two
  int edgeBits_ = 2;                       ///< its exponent
  glm::ivec3 bricksAlong_{0};
  std::vector<Brick> bricks_;
  std::vector<Entry> entries_;
};

}  // namespace orris
