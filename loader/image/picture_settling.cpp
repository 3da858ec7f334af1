#include <orris/image/picture_settling.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orris {
namespace {

constexpr int kSquare = 8;  // pixels: antialiasing moves a picture by less, and noise is seen through it
constexpr double kSameBrightness = 1.0 / 500;
constexpr double kSameSquares = 1.0 / 255;
// A mean of n independent frames differs from that of 2n by 0.71 of what it differed from that of n/2.
constexpr double kGoesOn = 0.8;

/// Means of squares; those at the right and lower edges may be smaller.
ImageF squaresOf(const Image8& picture) {
  ImageF squares((picture.width + kSquare - 1) / kSquare, (picture.height + kSquare - 1) / kSquare, 3);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const int wide = std::min(kSquare, picture.width - x / kSquare * kSquare);
      const int high = std::min(kSquare, picture.height - y / kSquare * kSquare);
      for (int c = 0; c < 3; ++c)
        squares.at(x / kSquare, y / kSquare)[c] += float(picture.at(x, y)[c]) / 255 / float(wide * high);
    }
  return squares;
}

}  // namespace

bool PictureSettling::settles(const Image8& picture) {
  ImageF squares = squaresOf(picture);
  const std::optional<ImageF> before = std::exchange(before_, squares);
  if (!before || before->pixels.size() != squares.pixels.size()) return false;
  double brighter = 0, differs = 0;
  for (std::size_t i = 0; i < squares.pixels.size(); ++i) {
    const double d = double(squares.pixels[i]) - double(before->pixels[i]);
    brighter += d;
    differs += d * d;
  }
  const auto count = double(squares.pixels.size());
  const double change = std::sqrt(differs / count);
  const std::optional<double> changeBefore = std::exchange(changeBefore_, change);
  const bool goesOn = changeBefore && change >= kGoesOn * *changeBefore;
  return std::abs(brighter) / count <= kSameBrightness && (change <= kSameSquares || goesOn);
}

}  // namespace orris
