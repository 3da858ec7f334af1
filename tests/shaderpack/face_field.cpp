#include "face_field.h"

#include <algorithm>

namespace orris::test {
namespace {

/// face_unit of include/face_cache/face_cache.glsl with the default EMISSION_STRENGTH.
constexpr float kFaceUnit = 16.0f / 2048;

int wrap(int a, int size) { return (a % size + size) % size; }

}  // namespace

std::array<float, 4> FaceField::at(glm::ivec3 block, Face face) const {
  const int x = wrap(block.x, volume_) * kFaces + face;
  const int y = wrap(block.z, volume_) * volume_ + wrap(block.y, volume_);
  const float* texel = light_.at(x, light_.height - 1 - y);  // images have their top row first
  return {texel[0], texel[1], texel[2], texel[3]};
}

double FaceField::meanRed(glm::ivec3 low, glm::ivec3 high, Face face) const {
  double sum = 0;
  int count = 0;
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x, ++count) sum += red({x, y, z}, face);
  return sum / count;
}

float FaceField::brightest() const {
  float largest = 0;
  for (size_t i = 0; i < light_.pixels.size(); i += 4)
    largest = std::max(largest, light_.pixels[i]);
  return largest;
}

FaceField faceField(PackSession& pack, int volume) {
  ImageF light = pack.dump("face_light");
  for (size_t i = 0; i < light.pixels.size(); ++i)
    if (i % 4 != 3) light.pixels[i] *= kFaceUnit;
  return {std::move(light), volume};
}

// The first texel of the last row.
int lastEdit(PackSession& pack) { return static_cast<int>(pack.dump("face_list").at(0, 0)[0]); }

// The first texel of the last row.
int updatedFaces(PackSession& pack) { return static_cast<int>(pack.dump("face_seen").at(0, 0)[0]); }

}  // namespace orris::test
