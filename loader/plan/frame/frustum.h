// View frustum culling of boxes.
#pragma once

#include <algorithm>
#include <glm/glm.hpp>

namespace orris {

/// Clip planes of a matrix, for boxes in the space it takes.
class Frustum {
 public:
  explicit Frustum(const glm::mat4& m) {
    const glm::mat4 t = glm::transpose(m);
    for (int i = 0; i < 3; ++i) {
      planes_[2 * i] = t[3] + t[i];
      planes_[2 * i + 1] = t[3] - t[i];
    }
  }
  bool outside(const glm::vec3& lo, const glm::vec3& hi) const {
    return std::any_of(std::begin(planes_), std::end(planes_), [&](const glm::vec4& p) {
      const glm::vec3 far(p.x > 0 ? hi.x : lo.x, p.y > 0 ? hi.y : lo.y, p.z > 0 ? hi.z : lo.z);
      return glm::dot(glm::vec3(p), far) + p.w < 0;
    });
  }

 private:
  glm::vec4 planes_[6];
};

}  // namespace orris
