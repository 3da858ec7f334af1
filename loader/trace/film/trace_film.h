// Sums of samples by pixel, in two independent halves, so that a picture brings its own noise.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include <orris/image/image.h>

namespace orris {

/// Every n-th tile of a picture, from the i-th on.
struct TraceShard {
  int index = 0, count = 1;
  bool operator==(const TraceShard&) const = default;
};

/// How far the two halves are apart, over the pixels of the shard.
struct TraceNoise {
  double mean = 0;      ///< of the picture's luminance
  double rms = 0;       ///< of half the difference of the halves: the error of their mean
  double relative = 0;  ///< rms / mean: the noise floor
  double median = 0;    ///< over pixels, of half the difference / (the pixel + 0.02 mean)
};

struct TraceFilm {
  int width = 0, height = 0;
  TraceShard shard;
  std::uint32_t samples = 0;  ///< of each half, in every pixel of the shard
  std::array<std::vector<glm::dvec3>, 2> sums;

  TraceFilm() = default;
  TraceFilm(int w, int h, TraceShard part);
  static constexpr int kTile = 16;
  /// Does the shard hold this tile? Tiles count from the top left, row by row.
  bool holdsTile(int tile) const { return tile % shard.count == shard.index; }
  int tileColumns() const { return (width + kTile - 1) / kTile; }
  int tileCount() const { return tileColumns() * ((height + kTile - 1) / kTile); }
  bool holdsPixel(int x, int y) const { return holdsTile(y / kTile * tileColumns() + x / kTile); }
  /// Mean radiance of a half.
  glm::dvec3 half(int which, int x, int y) const;

  TraceNoise noise() const;
  /// Channels: mean r g b, first half r g b, second half r g b; 0 outside of the shard.
  ImageF image() const;
};

}  // namespace orris
