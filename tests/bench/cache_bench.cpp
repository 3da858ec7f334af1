// bench_caches SAMPLES WORLD...: how far caches of light are from the reference in closed rooms, on the CPU, without a
// renderer: what is looked up, what it costs in rays, how much it flickers; the reference is of so many
// paths a pixel. One line of JSON a cache and world.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "light_caches.h"

namespace orris {
namespace {

constexpr int kColumns = 26;
constexpr int kWarmUp = 600, kFrames = 32, kLookups = 256;

double luminance(const glm::vec3& c) { return .2126 * c.r + .7152 * c.g + .0722 * c.b; }

/// Looked up by pixels, over frames.
class Errors {
 public:
  explicit Errors(const Room& room) : room_(room), sums_(room.points().size(), 0) {
    SampleRandom random(3, 0, 0);
    for (int i = 0; i < 300; ++i) {
      const auto pick = std::size_t(random.one() * float(room.points().size()));
      watched_.push_back(room.cosineHit(room.points()[pick].surface, random));
    }
    first_.resize(watched_.size());
    second_.resize(watched_.size());
  }

  void add(const LightCache& cache, SampleRandom& random) {
    for (std::size_t i = 0; i < room_.points().size(); ++i) {
      for (int k = 0; k < kLookups; ++k) {
        const RayHit hit = room_.cosineHit(room_.points()[i].surface, random);
        sums_[i] += luminance(room_.surfaceAt(hit).albedo * cache.light(hit));
      }
    }
    for (std::size_t i = 0; i < watched_.size(); ++i) {
      const double x = luminance(cache.light(watched_[i]));
      first_[i] += x;
      second_[i] += x * x;
    }
    ++frames_;
  }

  nlohmann::json result() const {
    double squares = 0, signedSum = 0, mean = 0;
    for (const RoomPoint& point : room_.points()) mean += luminance(point.reference);
    mean /= double(room_.points().size());
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const RoomPoint& point = room_.points()[i];
      const double reference = luminance(point.reference);
      const double x = luminance(point.direct) + sums_[i] / (double(frames_) * kLookups);
      const double error = (x - reference) / (reference + .02 * mean);
      squares += error * error;
      signedSum += error;
    }
    double flicker = 0;
    for (std::size_t i = 0; i < first_.size(); ++i) {
      const double m = first_[i] / frames_;
      const double variance =
          std::max(0.0, second_[i] / frames_ - m * m) * frames_ / (frames_ - 1.0);
      flicker += m > 0 ? variance / (m * m) : 0;
    }
    return {{"rms", std::sqrt(squares / double(sums_.size()))},
            {"signed", signedSum / double(sums_.size())},
            {"flicker", std::sqrt(flicker / double(first_.size()))}};
  }

 private:
  const Room& room_;
  std::vector<double> sums_;
  std::vector<RayHit> watched_;
  std::vector<double> first_, second_;
  int frames_ = 0;
};

void measure(const std::string& world, int samples) {
  const auto room = Room::open(world, kColumns, samples);
  if (!room) {
    fmt::print(stderr, "{}: cannot be read\n", world);
    return;
  }
  for (const NamedCache& named : makeLightCaches(*room)) {
    LightCache& cache = *named.cache;
    // Cascades have no noise to average, and cost hundreds of times as much.
    const bool cascades = named.name == "radiance cascades";
    const int warmUp = cascades ? 24 : kWarmUp, frames = cascades ? 4 : kFrames;
    SampleRandom random(11, 0, 0);
    for (int i = 0; i < warmUp; ++i) cache.frame(random);
    const std::uint64_t before = cache.rays();
    Errors errors(*room);
    for (int i = 0; i < frames; ++i) {
      cache.frame(random);
      errors.add(cache, random);
    }
    nlohmann::json line = errors.result();
    line["world"] = world;
    line["cache"] = named.name;
    line["raysPerFrame"] = (cache.rays() - before) / std::uint64_t(frames);
    line["kept"] = cache.kept();
    line["faces"] = room->faces().size();
    fmt::print("{}\n", line.dump());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace orris

int main(int argc, char** argv) {
  for (int i = 2; i < argc; ++i) orris::measure(argv[i], std::max(1, std::atoi(argv[1])));
}
