#include <orris/trace/film/checkpoint.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <sstream>

#include <orris/core/add_diagnostic.h>
#include <orris/core/files/replace_file.h>
#include <orris/trace/light/random.h>

namespace orris {
namespace {

constexpr char kMagic[8] = {'O', 'R', 'R', 'I', 'S', 'T', 'R', '1'};
constexpr std::uint32_t kMostSide = 16384;

struct Header {
  char magic[8];
  std::uint64_t key, checksum;
  std::uint32_t width, height, shardIndex, shardCount, samples, reserved;
};

class Digest {
 public:
  template <class T>
  Digest& add(const T& value) {
    static_assert(std::is_arithmetic_v<T>);
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof value);
    state_ = mixBits(state_ + 0x9e3779b97f4a7c15u) ^ bits * 0xd6e8feb86659fd93u;
    return *this;
  }
  template <int N, class T>
  Digest& add(const glm::vec<N, T>& value) {
    for (int i = 0; i < N; ++i) add(value[i]);
    return *this;
  }
  Digest& add(const glm::mat4& value) {
    for (int i = 0; i < 4; ++i) add(value[i]);
    return *this;
  }
  std::uint64_t value() const { return mixBits(state_); }

 private:
  std::uint64_t state_ = 0;
};

void addScene(Digest& digest, const TraceScene& scene) {
  digest.add(scene.origin).add(scene.grid.size());
  for (const TraceQuad& q : scene.grid.quads()) {
    digest.add(q.corner).add(q.edgeU).add(q.edgeV).add(q.uvCorner).add(q.tint).add(q.emission);
    digest.add(q.alphaTested).add(q.blended).add(q.translucent).add(q.filters).add(q.thin).add(q.water);
  }
  for (const glm::vec4& texel : scene.grid.texture().levels[0]) digest.add(texel);
  for (const LampFace& lamp : scene.lamps.faces()) digest.add(lamp.quad).add(lamp.radiance);
  const PackLighting& light = *scene.lighting;
  digest.add(light.lightDirection()).add(light.lightIrradiance());
  const glm::vec3 up(0, 1, 0), aside = glm::normalize(glm::vec3(1, 1, 0));
  for (const glm::vec3& direction : {up, aside, -aside, -up})
    digest.add(light.skyRadiance(direction));
  digest.add(light.reflectDirect(glm::vec3(0.5f), up, aside, up));
  for (const float scale : scene.emissionScale) digest.add(scale);
}

std::uint64_t checksumOf(const TraceFilm& film) {
  Digest digest;
  for (const auto& half : film.sums)
    for (const glm::dvec3& sum : half) digest.add(sum);
  return digest.value();
}

std::string refusal(const Header& header, std::uint64_t key) {
  if (std::memcmp(header.magic, kMagic, sizeof kMagic) != 0) return "is not a checkpoint of trace";
  const bool sizes = header.width >= 1 && header.height >= 1 && header.width <= kMostSide &&
                     header.height <= kMostSide && header.shardCount >= 1 &&
                     header.shardIndex < header.shardCount && header.shardCount <= kMostSide;
  if (!sizes) return "is damaged";
  return header.key == key ? "" : "is of another world, camera, size, seed, option or version of the tracer";
}

}  // namespace

std::uint64_t traceKey(const TraceScene& scene, const TraceCamera& camera, const TraceSettings& settings,
                       std::uint64_t code) {
  Digest digest;
  digest.add(code);
  addScene(digest, scene);
  digest.add(camera.position).add(camera.modelViewInverse).add(camera.projectionInverse);
  digest.add(camera.width).add(camera.height).add(settings.seed).add(settings.bounces);
  return digest.value();
}

bool writeCheckpoint(const std::string& path, const TraceFilm& film, std::uint64_t key,
                     Diagnostics& diagnostics) {
  Header header{};
  std::memcpy(header.magic, kMagic, sizeof kMagic);
  header.key = key;
  header.checksum = checksumOf(film);
  header.width = std::uint32_t(film.width);
  header.height = std::uint32_t(film.height);
  header.shardIndex = std::uint32_t(film.shard.index);
  header.shardCount = std::uint32_t(film.shard.count);
  header.samples = film.samples;
  const std::error_code error = replaceFile(path, [&](const std::string& partial) {
    std::ofstream file(partial, std::ios::binary);
    file.write(reinterpret_cast<const char*>(&header), sizeof header);
    for (const auto& half : film.sums) {
      file.write(reinterpret_cast<const char*>(half.data()),
                 std::streamsize(half.size() * sizeof(glm::dvec3)));
    }
    file.close();
    return bool(file);
  });
  if (!error) return true;
  return addError(diagnostics, "checkpoint-write", {path}, "cannot write the checkpoint",
                  "check that the folder exists, is writable and has room");
}

std::optional<TraceFilm> readCheckpoint(const std::string& path, std::uint64_t key,
                                        Diagnostics& diagnostics) {
  std::ifstream file(path, std::ios::binary);
  Header header{};
  if (!file || !file.read(reinterpret_cast<char*>(&header), sizeof header)) {
    addError(diagnostics, "checkpoint-read", {path}, "cannot be read as a checkpoint of trace");
    return std::nullopt;
  }
  std::string problem = refusal(header, key);
  if (problem.empty()) {
    TraceFilm film(int(header.width), int(header.height),
                   {int(header.shardIndex), int(header.shardCount)});
    film.samples = header.samples;
    for (auto& half : film.sums) {
      file.read(reinterpret_cast<char*>(half.data()),
                std::streamsize(half.size() * sizeof(glm::dvec3)));
    }
    if (file && checksumOf(film) == header.checksum) return film;
    problem = "is damaged";
  }
  addError(diagnostics, "checkpoint-read", {path}, problem,
           "trace again, or give the arguments that it was made with");
  return std::nullopt;
}

namespace {

/// Why a shard does not go with the first one; "" when it does.
std::string mismatch(const TraceFilm& part, const TraceFilm& first, const std::string& firstName,
                     const std::vector<bool>& seen) {
  if (part.shard.count != first.shard.count) {
    return fmt::format("is one of {} shards, {} one of {}", part.shard.count, firstName,
                       first.shard.count);
  }
  if (part.samples != first.samples) {
    return fmt::format("has {} samples a pixel, {} has {}", 2 * part.samples, firstName,
                       2 * first.samples);
  }
  const bool again = seen[std::size_t(part.shard.index)];
  return again ? fmt::format("is shard {}/{} again", part.shard.index + 1, part.shard.count) : "";
}

}  // namespace

std::optional<TraceFilm> mergeShards(const std::vector<TraceFilm>& shards,
                                     const std::vector<std::string>& names,
                                     Diagnostics& diagnostics) {
  const TraceFilm& first = shards.at(0);
  TraceFilm whole(first.width, first.height, {});
  whole.samples = first.samples;
  std::vector<bool> seen(std::size_t(first.shard.count), false);
  for (std::size_t i = 0; i < shards.size(); ++i) {
    const TraceFilm& part = shards[i];
    const std::string problem = mismatch(part, first, names[0], seen);
    if (!problem.empty()) {
      addError(diagnostics, "shard-mismatch", {names[i]}, problem,
               "name each shard of one picture once, all with as many samples (--samples)");
      return std::nullopt;
    }
    seen[std::size_t(part.shard.index)] = true;
    // A shard is 0 wherever it holds no pixel, and adding 0 changes no bit.
    for (std::size_t half = 0; half < 2; ++half)
      for (std::size_t p = 0; p < whole.sums[half].size(); ++p)
        whole.sums[half][p] += part.sums[half][p];
  }
  const auto missing = std::find(seen.begin(), seen.end(), false);
  if (missing == seen.end()) return whole;
  addError(diagnostics, "shard-missing", {names[0]},
           fmt::format("shard {}/{} is missing", missing - seen.begin() + 1, seen.size()),
           "name all shards");
  return std::nullopt;
}

}  // namespace orris
