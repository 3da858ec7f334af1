#include <orris/trace/light/lamps.h>

#include <algorithm>
#include <bit>

namespace orris {
namespace {

// Work of building the lists: bricks times faces.
constexpr double kMostPairs = 4e7;

double powerOf(const LampFace& face) {
  return double(face.radiance.r + face.radiance.g + face.radiance.b) * face.area;
}

/// Can any point of the box see the front?
bool facesBox(const LampFace& face, glm::vec3 low, glm::vec3 high) {
  if (face.radius > 0) return true;
  float farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float toward = face.normal[axis] > 0 ? high[axis] : low[axis];
    farthest += face.normal[axis] * (toward - face.corner[axis]);
  }
  return farthest > 0;
}

/// About what the face gives to a point in the box: no more than from a brick's own width away.
double importance(const LampFace& face, glm::vec3 low, glm::vec3 high) {
  if (!facesBox(face, low, high)) return 0;
  const glm::vec3 middle = face.corner + 0.5f * (face.edgeU + face.edgeV);
  const glm::vec3 away = glm::clamp(middle, low, high) - middle;
  const float half = 0.5f * (high.x - low.x);
  return powerOf(face) / double(glm::dot(away, away) + half * half);
}

}  // namespace

LampSet::LampSet(std::vector<LampFace> faces, glm::ivec3 gridSize) : faces_(std::move(faces)) {
  if (faces_.empty()) return;
  double total = 0, sum = 0;
  for (const LampFace& face : faces_) total += powerOf(face);
  for (const LampFace& face : faces_) {
    sum += powerOf(face);
    power_.push_back(float(powerOf(face) / total));
    cumulative_.push_back(float(sum / total));
  }
  const auto bricksAlong = [&] { return (gridSize + edge_ - 1) / edge_; };
  const auto count = [](glm::ivec3 n) { return double(n.x) * n.y * n.z; };
  while (edge_ < 512 && count(bricksAlong()) * double(faces_.size()) > kMostPairs) edge_ *= 2;
  bricksAlong_ = bricksAlong();
  edgeBits_ = std::countr_zero(unsigned(edge_));
  for (int y = 0; y < bricksAlong_.y; ++y)
    for (int z = 0; z < bricksAlong_.z; ++z)
      for (int x = 0; x < bricksAlong_.x; ++x) {
        const glm::vec3 low = glm::vec3(x, y, z) * float(edge_);
        list(low, low + float(edge_));
      }
}

void LampSet::list(glm::vec3 low, glm::vec3 high) {
  struct Candidate {
    double weight;
    std::uint32_t face;
  };
  std::vector<Candidate> candidates;
  double total = 0;
  for (std::uint32_t i = 0; i < faces_.size(); ++i) {
    const double weight = importance(faces_[i], low, high);
    if (weight > 0) candidates.push_back({weight, i});
    total += weight;
  }
  const std::size_t kept = std::min(candidates.size(), kListed);
  std::nth_element(candidates.begin(), candidates.begin() + std::ptrdiff_t(kept), candidates.end(),
                   [](const Candidate& a, const Candidate& b) {
                     return a.weight != b.weight ? a.weight > b.weight : a.face < b.face;
                   });
  std::sort(candidates.begin(), candidates.begin() + std::ptrdiff_t(kept),
            [](const Candidate& a, const Candidate& b) { return a.face < b.face; });
  Brick brick{std::uint32_t(entries_.size()), std::uint32_t(kept), 0};
  double sum = 0;
  for (std::size_t i = 0; i < kept; ++i) {
    sum += candidates[i].weight;
    entries_.push_back({candidates[i].face, float(candidates[i].weight / total)});
  }
  brick.listed = kept == candidates.size() ? 1 : float(sum / total);
  makeAliases(brick);
  bricks_.push_back(brick);
}

void LampSet::makeAliases(const Brick& brick) {
  std::vector<double> share;
  std::vector<std::uint32_t> small, large;
  for (std::uint32_t i = 0; i < brick.count; ++i) {
    share.push_back(double(entries_[brick.first + i].probability) / brick.listed * brick.count);
    (share[i] < 1 ? small : large).push_back(i);
  }
  while (!small.empty() && !large.empty()) {
    const std::uint32_t poor = small.back(), rich = large.back();
    small.pop_back();
    entries_[brick.first + poor].keep = float(share[poor]);
    entries_[brick.first + poor].other = rich;
    share[rich] -= 1 - share[poor];
    if (share[rich] >= 1) continue;
    large.pop_back();
    small.push_back(rich);
  }
}

const LampSet::Brick& LampSet::brickOf(glm::ivec3 cell) const {
  const glm::ivec3 b = glm::clamp(cell >> edgeBits_, glm::ivec3(0), bricksAlong_ - 1);
  return bricks_[std::size_t(b.x) +
                 std::size_t(bricksAlong_.x) *
                     (std::size_t(b.z) + std::size_t(bricksAlong_.z) * std::size_t(b.y))];
}

float LampSet::probability(glm::ivec3 cell, std::uint32_t face) const {
  const Brick& brick = brickOf(cell);
  const Entry* first = entries_.data() + brick.first;
  const Entry* end = first + brick.count;
  const Entry* found = std::lower_bound(
      first, end, face, [](const Entry& entry, std::uint32_t value) { return entry.face < value; });
  const float listed = found != end && found->face == face ? found->probability : 0;
  return listed + (1 - brick.listed) * power_[face];
}

LampDraw LampSet::draw(glm::ivec3 cell, float u) const {
  const Brick& brick = brickOf(cell);
  if (brick.count == 0) return {};
  if (u < brick.listed) {
    const Entry* first = entries_.data() + brick.first;
    const float place = u / brick.listed * float(brick.count);
    const std::uint32_t slot = std::min(std::uint32_t(place), brick.count - 1);
    const bool stays = place - float(slot) < first[slot].keep;
    const Entry& entry = first[stays ? slot : first[slot].other];
    return {&faces_[entry.face], entry.probability + (1 - brick.listed) * power_[entry.face]};
  }
  const float rest = (u - brick.listed) / (1 - brick.listed);
  const auto found = std::upper_bound(cumulative_.begin(), cumulative_.end(), rest);
  const auto index = std::min(std::size_t(found - cumulative_.begin()), faces_.size() - 1);
  return {&faces_[index], probability(cell, std::uint32_t(index))};
}

}  // namespace orris
