// Rays through a grid of blocks. Each empty cell knows, for the eight octants of directions, how
// large a box of empty cells begins there: a ray leaps from box to box instead of walking cells.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include <orris/trace/grid/open_boxes.h>
#include <orris/trace/grid/ray.h>
#include <orris/world/atlas/atlas_levels.h>

namespace orris {

/// A rectangle: corner, edges, unit normal; texture coordinates run along the edges.
struct TraceQuad {
  glm::vec3 corner{0}, edgeU{0}, edgeV{0}, normal{0};
  glm::vec2 uvCorner{0}, uvU{0}, uvV{0};  ///< atlas texels
  glm::vec3 tint{1};                      ///< linear, times the texture
  std::uint32_t lamp = kNoQuad;           ///< index of its lamp face
  std::uint16_t state = 0;                ///< palette index
  std::uint8_t emission = 0;              ///< light level 0..15
  bool alphaTested = false;               ///< holes where the texture is
  bool blended = false;                   ///< the camera sees what is behind, too
  bool translucent = false;               ///< light passes
  bool filters = false;    ///< translucent and no block of it: tints rays that meet its front
  bool thin = false;       ///< lit from both sides
  std::uint32_t twin = kNoQuad;  ///< the same rectangle seen from behind; set by the grid
  std::uint8_t gloss = 0;        ///< class of the pack's mirrors; 0: diffuse
  bool water = false;      ///< mirrors at grazing angles
};

/// What of a quad a ray is tested with.
struct QuadPlane {
  glm::vec3 normal{0};
  float offset = 0;  ///< of points on it along the normal
  glm::vec3 alongU{0};
  float startU = 0;  ///< dot(point, alongU) - startU is 0..1 on the quad
  glm::vec3 alongV{0};
  float startV = 0;
};

/// Number of faces of a set that come before each; the last entry counts all.
struct FaceRanks {
  std::uint8_t rank[64][7];
};
constexpr FaceRanks makeFaceRanks() {
  FaceRanks ranks{};
  for (int mask = 0; mask < 64; ++mask) {
    for (int face = 0; face < 6; ++face)
      ranks.rank[mask][face + 1] = std::uint8_t(ranks.rank[mask][face] + (mask >> face & 1));
  }
  return ranks;
}
inline constexpr FaceRanks kFaceRanks = makeFaceRanks();

/// What a cell does to a ray.
struct TraceCell {
  std::uint32_t firstQuad = 0;
  std::uint16_t quadCount = 0;
  std::uint8_t faces = 0;   ///< full sides: bit by FaceDirection; quads are sorted by it
  std::uint8_t filter = 0;  ///< index in `filters`, 0 none
  bool cube = false;        ///< full and opaque
  bool hollow = false;      ///< full sides with holes, nothing else
  bool stops = false;       ///< some quad matters to light
};

/// Matter that fills cells up to a height: a block's depth of it lets `color` through.
struct TraceFilter {
  glm::vec3 color{1};
  float height = 1;
  glm::vec3 logarithm{0};  ///< of color
};

/// Texels of the atlas, linear; alpha in w. Level 0 is the full size, each further one half of it.
struct TraceTexture {
  static constexpr int kLevels = kAtlasLevels;
  int width = 0, height = 0;
  std::array<std::vector<glm::vec4>, kLevels> levels;
  const glm::vec4& at(const glm::vec2& texel, int level = 0) const {
    const int w = width >> level, h = height >> level;
    const int x = glm::clamp(int(texel.x) >> level, 0, w - 1);
    const int y = glm::clamp(int(texel.y) >> level, 0, h - 1);
    return levels[std::size_t(level)][std::size_t(y) * std::size_t(w) + std::size_t(x)];
  }
};

/// Where between two levels a texture is read: share 0 is `level` alone.
struct TextureLevel {
  int level = 0;
  float next = 0;  ///< share of level + 1
};

/// The pixel behind a camera's ray, by the rays of the first, the right and the lower pixel of its
/// square of four, from which a rasteriser takes the level of the texture.
struct PixelFootprint {
  glm::vec3 origin{0};
  std::array<glm::vec3, 3> rays{};
  bool whole = false;  ///< cutouts are met as if they had no holes
};

/// Alpha below which a cutout texture has a hole: what the pack's programs and Iris use.
constexpr float kAlphaTest = 0.1f;

class VoxelGrid {
 public:
  VoxelGrid() = default;
  /// `cells` are those that are not empty, by offset x + size.x * (z + size.z * y).
  VoxelGrid(glm::ivec3 size, const std::vector<std::uint32_t>& offsets,
            std::vector<TraceCell> cells, std::vector<TraceQuad> quads,
            std::vector<TraceFilter> filters, TraceTexture texture);

  /// The first quad that stops light; translucent ones do not.
  RayHit intersect(const Ray& ray) const;
  /// The same into a fresh hit, looking no farther than its distance: filters behind that take nothing.
  void intersect(const Ray& ray, RayHit& hit) const;
  /// Two rays in about the time of one and a half.
  void intersect(const Ray& first, RayHit& firstHit, const Ray& second, RayHit& secondHit) const;
  /// The first that a camera sees: fronts only, translucent ones too.
  RayHit look(const Ray& ray, const PixelFootprint* footprint) const;
  /// Moves a ray that starts outside to where it enters the grid; false: it misses.
  bool enter(Ray& ray) const;

  glm::ivec3 size() const { return size_; }
  bool contains(glm::ivec3 cell) const;
  const TraceQuad& quad(std::uint32_t index) const { return quads_[index]; }
  const std::vector<TraceQuad>& quads() const { return quads_; }
  const TraceTexture& texture() const { return texture_; }
  /// Linear colour and alpha of a quad at a place on it.
  glm::vec4 texel(const TraceQuad& quad, const glm::vec2& at) const {
    return texture_.at(quad.uvCorner + quad.uvU * at.x + quad.uvV * at.y) * glm::vec4(quad.tint, 1);
  }
  /// The same blended from two levels as they are stored, as GL does.
  glm::vec4 texel(const TraceQuad& quad, const glm::vec2& at, const TextureLevel& level) const;
  /// The levels in which a rasteriser would read the quad's texture; 0 without a footprint.
  TextureLevel textureLevel(std::uint32_t quad, const PixelFootprint* footprint) const;
  /// Is there a way from this cell to the outside, past cells that are no full cubes?
  bool isOpen(glm::ivec3 cell) const { return !contains(cell) || open_[offset(cell)] != 0; }

 private:
  template <bool kCamera>
  class Walk;
  void pairTwins(const TraceCell& cell);
  void floodFromOutside();
  std::size_t offset(glm::ivec3 p) const {
    return std::size_t(p.x) +
           std::size_t(size_.x) * (std::size_t(p.z) + std::size_t(size_.z) * std::size_t(p.y));
  }

  glm::ivec3 size_{0};
  std::vector<std::uint32_t> cellAt_;  ///< index in cells_, 0 empty
  std::vector<TraceCell> cells_;
  std::vector<TraceQuad> quads_;
  std::vector<QuadPlane> planes_;  ///< of quads_
  std::vector<TraceFilter> filters_;
  TraceTexture texture_;
  OpenBoxes boxes_;
  std::vector<std::uint8_t> open_;
};

}  // namespace orris
