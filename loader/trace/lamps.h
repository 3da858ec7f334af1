// The faces that give light, and how one of them is drawn at random.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "trace/ray.h"

namespace orris {

/// One face of a lamp; its front gives `radiance`.
struct LampFace {
  std::uint32_t quad = 0;
  glm::ivec3 cell{0};
  glm::vec3 radiance{0};
  float area = 1;
  float probability = 0;  ///< of being drawn
};

class LampSet {
 public:
  LampSet() = default;
  explicit LampSet(std::vector<LampFace> faces);
  bool empty() const { return faces_.empty(); }
  const LampFace& face(std::uint32_t index) const { return faces_[index]; }
  const std::vector<LampFace>& faces() const { return faces_; }
  /// In proportion to power; `u` 0..1.
  const LampFace& draw(float u) const;

 private:
  std::vector<LampFace> faces_;
  std::vector<float> cumulative_;
};

}  // namespace orris
