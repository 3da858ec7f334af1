#include "face_boiling.h"

#include <algorithm>
#include <cmath>

namespace orris::test {
namespace {

constexpr glm::ivec3 kNormals[6] = {{-1, 0, 0}, {1, 0, 0},  {0, -1, 0},
                                    {0, 1, 0},  {0, 0, -1}, {0, 0, 1}};

}  // namespace

void FaceBoiling::add(const FaceField& field) {
  const std::size_t count = std::size_t(6) * size_.x * size_.y * size_.z;
  sums_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const int face = int(i % 6), cell = int(i / 6);
    const glm::ivec3 at(cell % size_.x, cell / size_.x % size_.y, cell / (size_.x * size_.y));
    const glm::ivec3 before = at + kNormals[face];
    const bool inside = before.x >= 0 && before.y >= 0 && before.z >= 0 && before.x < size_.x &&
                        before.y < size_.y && before.z < size_.z;
    if (!inside) continue;
    const auto [r, g, b, updates] = field.at(origin_ + at, Face(face));
    const double light = double(r) + g + b;
    sums_[i].light += light;
    sums_[i].squares += light * light;
  }
  ++frames_;
}

double FaceBoiling::varianceOf(const Sum& sum) const {
  const double mean = meanOf(sum);
  return std::max(0.0, sum.squares / frames_ - mean * mean) * frames_ / (frames_ - 1);
}

int FaceBoiling::faces() const {
  return int(std::count_if(sums_.begin(), sums_.end(), [](const Sum& s) { return s.light > 0; }));
}

double FaceBoiling::mean() const {
  double sum = 0;
  for (const Sum& face : sums_) sum += meanOf(face);
  return sum / faces();
}

double FaceBoiling::overMean() const {
  double variance = 0;
  for (const Sum& face : sums_) variance += varianceOf(face);
  return std::sqrt(variance / faces()) / mean();
}

double FaceBoiling::ofFaces() const {
  double sum = 0;
  for (const Sum& face : sums_)
    if (face.light > 0) sum += varianceOf(face) / std::pow(meanOf(face) + 0.02 * mean(), 2);
  return std::sqrt(sum / faces());
}

}  // namespace orris::test
