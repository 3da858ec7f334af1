#include "light_caches.h"

#include <unordered_map>

namespace orris {
namespace {

constexpr int kShare = 4, kWindow = 32;  // FACE_SHARE, FACE_WINDOW
constexpr float kGain = 8;               // FACE_GAIN

struct Mean {
  glm::vec3 value{0};
  int updates = 0;
  void add(const glm::vec3& x) {
    const float weight =
        updates == 0 ? 1 : std::max(1.0f / kWindow, kGain / (float(updates) + kGain));
    value += weight * (x - value);
    ++updates;
  }
};

/// One value a face.
class FaceCache : public LightCache {
 public:
  explicit FaceCache(const Room& room) : LightCache(room), means_(room.grid().quads().size()) {}
  void frame(SampleRandom& random) override {
    for (std::size_t i = turn_++ % kShare; i < room_.faces().size(); i += kShare) {
      RayHit hit;
      const std::uint32_t face = room_.faces()[i];
      means_[face].add(sampleAt(room_.onFace(face, random), random, hit));
    }
  }
  glm::vec3 light(const RayHit& hit) const override { return means_[hit.quad].value; }
  std::size_t kept() const override { return room_.faces().size(); }

 protected:
  std::vector<Mean> means_;
  std::size_t turn_ = 0;
};

/// The same, but samples go to the faces that rays from pixels meet, and to those that these look at.
class PixelFilledCache : public FaceCache {
 public:
  using FaceCache::FaceCache;
  void frame(SampleRandom& random) override {
    const std::size_t budget = room_.faces().size() / kShare;
    std::vector<std::uint32_t> wanted;
    wanted.swap(seen_);
    while (wanted.size() < budget) {
      const auto pick = std::size_t(random.one() * float(room_.points().size()));
      wanted.push_back(room_.cosineHit(room_.points()[pick].surface, random).quad);
    }
    for (const std::uint32_t face : wanted) {
      RayHit hit;
      means_[face].add(sampleAt(room_.onFace(face, random), random, hit));
      if (seen_.size() < budget / 2) seen_.push_back(hit.quad);
    }
  }

 private:
  std::vector<std::uint32_t> seen_;  ///< faces that the last samples looked at
};

/// Each face keeps what a window of rays met, and sums the light of these faces anew each frame.
class LinkCache : public LightCache {
 public:
  LinkCache(const Room& room, bool refreshed)
      : LightCache(room), refreshed_(refreshed), links_(room.grid().quads().size()) {}
  void frame(SampleRandom& random) override {
    if (turn_ == 0)
      for (const std::uint32_t face : room_.faces())
        for (int i = 0; i < kWindow; ++i) replace(face, random);
    for (std::size_t i = turn_++ % kShare; refreshed_ && i < room_.faces().size(); i += kShare)
      replace(room_.faces()[i], random);
    std::vector<glm::vec3> next(links_.size(), glm::vec3(0));
    for (const std::uint32_t face : room_.faces()) {
      for (const Link& link : links_[face].ring)
        next[face] += (link.direct + link.albedo * lightOf(link.quad)) / float(kWindow);
    }
    light_.swap(next);
  }
  glm::vec3 light(const RayHit& hit) const override { return lightOf(hit.quad); }
  std::size_t kept() const override { return room_.faces().size() * (1 + 3 * kWindow); }

 private:
  struct Link {
    glm::vec3 direct{0}, albedo{0};
    std::uint32_t quad = kHiddenQuad;
  };
  struct Links {
    std::vector<Link> ring = std::vector<Link>(kWindow);
    int next = 0;
  };
  glm::vec3 lightOf(std::uint32_t quad) const {
    return light_.empty() ? glm::vec3(0) : light_[quad];
  }
  void replace(std::uint32_t face, SampleRandom& random) {
    const TraceSurface surface = room_.onFace(face, random);
    const RayHit hit = room_.cosineHit(surface, random);
    Links& links = links_[face];
    links.ring[std::size_t(links.next++ % kWindow)] = {room_.directAt(surface, random),
                                                       room_.surfaceAt(hit).albedo, hit.quad};
    rays_ += 2;
  }

  bool refreshed_;
  std::size_t turn_ = 0;
  std::vector<Links> links_;
  std::vector<glm::vec3> light_;
};

/// In each cell beside a wall, the light on six faces of its middle; a lookup takes of the eight cells about
/// it those that it sees.
class ProbeCache : public LightCache {
 public:
  explicit ProbeCache(const Room& room) : LightCache(room) {
    for (const std::uint32_t face : room.faces()) {
      RayHit hit;
      hit.quad = face;
      const glm::ivec3 cell = room.surfaceAt(hit).cell;
      if (index_.emplace(key(cell), probes_.size()).second) probes_.push_back({cell});
    }
  }
  void frame(SampleRandom& random) override {
    const auto side = std::size_t(turn_++ % 6);
    for (Probe& probe : probes_) {
      TraceSurface surface;
      surface.position = glm::vec3(probe.cell) + 0.5f;
      surface.normal[int(side) / 2] = side % 2 == 0 ? 1 : -1;
      surface.cell = probe.cell;
      RayHit hit;
      probe.sides[side].add(sampleAt(surface, random, hit));
    }
  }
  glm::vec3 light(const RayHit& hit) const override {
    const TraceSurface surface = room_.surfaceAt(hit);
    const glm::vec3 place = surface.position + 0.5f * surface.normal - 0.5f;
    const glm::ivec3 low(glm::floor(place));
    glm::vec3 sum(0);
    float weights = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 cell = low + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
      const auto found = index_.find(key(cell));
      if (found == index_.end() || !sees(surface, cell)) continue;
      const glm::vec3 near = 1.0f - glm::abs(place - glm::vec3(cell));
      const float weight = std::max(near.x * near.y * near.z, 1e-4f);
      sum += weight * probes_[found->second].sides[sideOf(surface.normal)].value;
      weights += weight;
    }
    return weights > 0 ? sum / weights : glm::vec3(0);
  }
  std::size_t kept() const override { return 6 * probes_.size(); }

 private:
  struct Probe {
    glm::ivec3 cell{0};
    Mean sides[6];
  };
  static std::uint64_t key(glm::ivec3 cell) {
    return (std::uint64_t(cell.x) << 42) ^ (std::uint64_t(cell.y) << 21) ^ std::uint64_t(cell.z);
  }
  static std::size_t sideOf(const glm::vec3& normal) {
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(normal[axis]) > 0.5f) return std::size_t(2 * axis + (normal[axis] < 0));
    return 0;
  }
  bool sees(const TraceSurface& from, glm::ivec3 cell) const {
    const glm::vec3 to = glm::vec3(cell) + 0.5f - from.position;
    Ray ray;
    ray.origin = from.position;
    ray.direction = withoutZeros(glm::normalize(to));
    ray.cell = from.cell;
    ray.ignore = from.quad;
    return room_.grid().intersect(ray).distance > glm::length(to);
  }

  std::unordered_map<std::uint64_t, std::size_t> index_;
  std::vector<Probe> probes_;
  int turn_ = 0;
};

}  // namespace

glm::vec3 LightCache::reflected(const RayHit& hit) const {
  if (hit.quad == kNoQuad || hit.back) return glm::vec3(0);
  return room_.surfaceAt(hit).albedo * light(hit);
}

glm::vec3 LightCache::sampleAt(const TraceSurface& surface, SampleRandom& random, RayHit& hit) {
  hit = room_.cosineHit(surface, random);
  rays_ += 2;
  return room_.directAt(surface, random) + reflected(hit);
}

std::vector<NamedCache> makeLightCaches(const Room& room) {
  std::vector<NamedCache> caches;
  caches.push_back({"faces", std::make_unique<FaceCache>(room)});
  caches.push_back({"faces filled by pixels' rays", std::make_unique<PixelFilledCache>(room)});
  caches.push_back({"links, frozen", std::make_unique<LinkCache>(room, false)});
  caches.push_back({"links, refreshed", std::make_unique<LinkCache>(room, true)});
  caches.push_back({"probes that see", std::make_unique<ProbeCache>(room)});
  caches.push_back({"radiance cascades", makeCascades(room)});
  return caches;
}

}  // namespace orris
