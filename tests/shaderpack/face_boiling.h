// How much the face cache of a scene at rest changes from frame to frame.
#pragma once

#include <vector>

#include "face_field.h"

namespace orris::test {

/// Mean and variance over frames of the light on each face of a world that looks into it.
class FaceBoiling {
 public:
  /// Blocks from `origin` on; faces on the outside of this box are left out.
  FaceBoiling(glm::ivec3 origin, glm::ivec3 size) : origin_(origin), size_(size) {}
  void add(const FaceField& field);
  /// Standard deviation over frames, rms over the faces, as a share of their mean light.
  double overMean() const;
  /// Rms over the lit faces of standard deviation / (own mean + 0.02 mean of all).
  double ofFaces() const;
  int faces() const;  ///< lit ones

 private:
  struct Sum {
    double light = 0, squares = 0;
  };
  double meanOf(const Sum& sum) const { return sum.light / frames_; }
  double varianceOf(const Sum& sum) const;
  double mean() const;  ///< of the lit faces
  glm::ivec3 origin_, size_;
  std::vector<Sum> sums_;
  int frames_ = 0;
};

}  // namespace orris::test
