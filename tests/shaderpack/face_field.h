// The face cache of our pack read back: light and number of updates by block and face.
#pragma once

#include <array>
#include <utility>

#include "pack_session.h"

namespace orris::test {

inline constexpr int kFaceVolume = 32;  ///< VOXEL_SIZE of most tests

/// Places of a cell's faces in the cache (include/face_cache/face_cache.glsl); the last three lie in its middle.
enum Face { kWest, kEast, kDown, kUp, kNorth, kSouth, kInnerX, kInnerY, kInnerZ, kFaces };

class FaceField {
 public:
  FaceField(ImageF light, int volume) : light_(std::move(light)), volume_(volume) {}
  /// Red, green, blue and number of updates of a face, by world block.
  std::array<float, 4> at(glm::ivec3 block, Face face) const;
  float red(glm::ivec3 block, Face face) const { return at(block, face)[0]; }
  int updates(glm::ivec3 block, Face face) const { return static_cast<int>(at(block, face)[3]); }
  /// Mean red of the same face of a box of blocks, corners included.
  double meanRed(glm::ivec3 low, glm::ivec3 high, Face face) const;
  float brightest() const;  ///< largest red

 private:
  ImageF light_;
  int volume_ = 0;
};

/// The cache after the last frame; `volume` is VOXEL_SIZE.
FaceField faceField(PackSession& pack, int volume);

/// Frame of the last edit that the cache noticed.
int lastEdit(PackSession& pack);

/// Faces that the last frame updated.
int updatedFaces(PackSession& pack);

}  // namespace orris::test
