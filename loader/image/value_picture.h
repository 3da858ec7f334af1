// Values of any buffer as a picture: a range of them from black to white or in false colours, and marks
// on what is no colour.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <orris/image/image.h>

namespace orris {

/// What stands in a buffer. Texels count once, however many of their channels are so.
struct ValueFacts {
  int channels = 0;
  std::array<float, 4> low{}, high{};  ///< of the finite values of each channel; 0 where there are none
  std::size_t nan = 0, infinite = 0, negative = 0;  ///< texels
};
ValueFacts valueFacts(const ImageF& image);

struct ValuePaint {
  int channel = -1;  ///< from 0; -1: the first three as red, green, blue
  /// These become black and white. None: the finite values shown, without the lowest and the highest of
  /// each 200.
  std::optional<std::pair<float, float>> range;
  bool falseColor = false;    ///< dark blue, violet, red, orange, pale yellow; of one channel
  bool markNegative = true;
};

/// What becomes black and white.
std::pair<float, float> paintedRange(const ImageF& image, const ValuePaint& paint);

/// RGB. Texels with a NaN are magenta, with an Inf cyan, with a negative value green. A channel that the image
/// does not have is painted like its last one; a false colour of three channels is that of their mean.
Image8 paintValues(const ImageF& image, const ValuePaint& paint);

/// `share` from 0 to 1, as false colour.
std::array<std::uint8_t, 3> falseColor(float share);

}  // namespace orris
