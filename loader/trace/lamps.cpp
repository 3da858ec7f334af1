#include "trace/lamps.h"

#include <algorithm>

namespace orris {

LampSet::LampSet(std::vector<LampFace> faces) : faces_(std::move(faces)) {
  double total = 0;
  const auto power = [](const LampFace& face) {
    return double(face.radiance.r + face.radiance.g + face.radiance.b) * face.area;
  };
  for (const LampFace& face : faces_) total += power(face);
  double sum = 0;
  for (LampFace& face : faces_) {
    face.probability = float(power(face) / total);
    sum += power(face);
    cumulative_.push_back(float(sum / total));
  }
}

const LampFace& LampSet::draw(float u) const {
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), u);
  const auto index = std::min(std::size_t(found - cumulative_.begin()), faces_.size() - 1);
  return faces_[index];
}

}  // namespace orris
