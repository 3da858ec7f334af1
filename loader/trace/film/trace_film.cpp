#include <orris/trace/film/trace_film.h>

#include <algorithm>
#include <cmath>

namespace orris {
namespace {

double luminance(const glm::dvec3& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

double medianOf(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

TraceFilm::TraceFilm(int w, int h, TraceShard part) : width(w), height(h), shard(part) {
  for (auto& half : sums) half.assign(std::size_t(w) * std::size_t(h), glm::dvec3(0));
}

glm::dvec3 TraceFilm::half(int which, int x, int y) const {
  return sums[std::size_t(which)][std::size_t(y) * std::size_t(width) + std::size_t(x)] /
         double(std::max(samples, 1u));
}

TraceNoise TraceFilm::noise() const {
  TraceNoise noise;
  std::vector<double> means, errors;
  double squares = 0, total = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (!holdsPixel(x, y)) continue;
      const double a = luminance(half(0, x, y)), b = luminance(half(1, x, y));
      means.push_back((a + b) / 2);
      errors.push_back(std::abs(a - b) / 2);
      total += (a + b) / 2;
      squares += (a - b) * (a - b) / 4;
    }
  }
  if (means.empty()) return noise;
  noise.mean = total / double(means.size());
  noise.rms = std::sqrt(squares / double(means.size()));
  noise.relative = noise.mean > 0 ? noise.rms / noise.mean : 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double scale = means[i] + 0.02 * noise.mean;
    errors[i] = scale > 0 ? errors[i] / scale : 0;
  }
  noise.median = medianOf(errors);
  return noise;
}

ImageF TraceFilm::image() const {
  ImageF image(width, height, 9);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 a = half(0, x, y), b = half(1, x, y), mean = (a + b) * 0.5;
      float* pixel = image.at(x, y);
      for (int c = 0; c < 3; ++c) {
        pixel[c] = float(mean[c]);
        pixel[3 + c] = float(a[c]);
        pixel[6 + c] = float(b[c]);
      }
    }
  }
  return image;
}

}  // namespace orris
