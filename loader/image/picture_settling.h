// Whether a picture that is drawn frame after frame goes on to become another one: its exposure adapts, noise is
// averaged away, edges become smooth. Clouds and waves move for ever and do not count.
#pragma once

#include <optional>

#include <orris/image/image.h>

namespace orris {

class PictureSettling {
 public:
  /// Pictures come after so many frames, then after twice as many each time.
  static constexpr int kFirstLook = 8;

  /// Whether this picture has the brightness of the one before, to 1/500 of white in all of it, and either looks
  /// like it in squares of 8x8 pixels, to 1/255, or differs from it not much less than that one differed from its
  /// predecessor, as what moves does.
  bool settles(const Image8& picture);

 private:
  std::optional<ImageF> before_;         ///< means of squares
  std::optional<double> changeBefore_;
};

}  // namespace orris
