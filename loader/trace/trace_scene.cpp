#include <orris/trace/trace_scene.h>

#include <algorithm>
#include <bit>
#include <map>
#include <numbers>
#include <tuple>

#include <orris/trace/grid/scene_quads.h>
#include <orris/trace/shown_area.h>
#include <orris/world/mesh/block_faces.h>

namespace orris {
namespace {

constexpr float kFluidHeight = 8.0f / 9;  // of a surface, as drawn

bool isWhole(const BlockFacts& facts) {
  return facts.boxes.size() == 1 && facts.boxes[0].from == glm::vec3(0) &&
         facts.boxes[0].to == glm::vec3(16);
}

/// Models may lay one quad over another; `placed` is sorted by face.
bool oneEachSide(const std::vector<PlacedQuad>& placed, std::size_t first, std::size_t end) {
  const auto last = placed.begin() + std::ptrdiff_t(end);
  return std::adjacent_find(placed.begin() + std::ptrdiff_t(first), last,
                            [](const PlacedQuad& a, const PlacedQuad& b) {
                              return a.face == b.face;
                            }) == last;
}

bool anyOf(const std::vector<PlacedQuad>& placed, std::size_t first, std::size_t end,
           bool (*test)(const PlacedQuad&)) {
  return std::any_of(placed.begin() + std::ptrdiff_t(first), placed.begin() + std::ptrdiff_t(end),
                     test);
}

class SceneBuilder {
 public:
  explicit SceneBuilder(const TraceSceneInput& input)
      : input_(input),
        lighting_(std::make_shared<PackLighting>(input.lighting)),
        texture_(linearTexture(input.atlas.albedo)),
        placed_(placeQuads(input.mesh, input.atlas)) {}

  TraceScene build() {
    describeStates();
    measure();
    quads_.emplace_back().tint = glm::vec3(0);  // kHiddenQuad
    addCells();
    TraceScene scene;
    scene.origin = low_;
    for (const State& state : states_) scene.stateFilters.push_back(filters_[state.filter].color);
    scene.grid = VoxelGrid(size_, offsets_, std::move(cells_), std::move(quads_),
                           std::move(filters_), std::move(texture_));
    scene.lamps = LampSet(std::move(lamps_), size_);
    scene.lighting = lighting_;
    for (int level = 0; level < 16; ++level)
      scene.emissionScale.push_back(lighting_->emissionScale(level));
    return scene;
  }

 private:
  /// What all blocks of one palette entry share.
  struct State {
    bool seen = false;
    bool thin = false, water = false, emits = false;
    std::uint8_t gloss = 0;
    std::uint8_t filter = 0, surface = 0;  ///< of a whole cell; with air above it
    glm::vec3 radiance{0};                 ///< of the sides of its cube, or of the ball
    float ball = 0;                        ///< radius
    int topFace = -1;
  };

  void describeStates();
  void measure();
  void addCells();
  void addCell(glm::ivec3 cell, std::size_t first, std::size_t end);
  void addLamp(glm::ivec3 cell, const TraceQuad& quad);
  void addBall(glm::ivec3 cell, const State& state);
  float shareOfFaces(glm::ivec3 cell);
  std::uint8_t filterAt(glm::ivec3 cell) const;

  const TraceSceneInput& input_;
  std::shared_ptr<PackLighting> lighting_;
  TraceTexture texture_;
  std::vector<PlacedQuad> placed_;
  std::vector<State> states_;
  glm::ivec3 low_{0}, size_{0};
  std::vector<std::uint32_t> offsets_;
  std::vector<TraceCell> cells_;
  std::vector<TraceQuad> quads_;
  std::vector<TraceFilter> filters_{{}};
  std::vector<LampFace> lamps_;
  /// By block state, sides of the cube that are open, and sides that are not shut.
  std::map<std::tuple<std::uint32_t, std::uint8_t, std::uint8_t>, float> shares_;
};

// The pack gives a block the colour of its top face; so do lamps and filters here.
void SceneBuilder::describeStates() {
  states_.resize(input_.facts.size());
  for (const PlacedQuad& placed : placed_) {
    State& state = states_[placed.quad.state];
    const int up = int(FaceDirection::Up);
    if (state.seen && (state.topFace == up || placed.face != up)) continue;
    state.seen = true;
    state.topFace = placed.face;
    const BlockFacts& facts = input_.facts[placed.quad.state];
    const int id = input_.blockIds[placed.quad.state];
    const glm::vec4 mean = meanTexel(texture_, placed.quad);
    state.thin = lighting_->isThin(id);
    state.water = lighting_->isWater(id);
    state.gloss = std::uint8_t(lighting_->gloss(id));
    if (placed.quad.emission > 0) {
      const LampLight light = lighting_->lampLight(id, placed.quad.emission, glm::vec3(mean));
      state.ball = light.radius;
      state.radiance = light.radiance;
      state.emits = true;
    } else if (placed.quad.translucent && (facts.fluid || isWhole(facts)) &&
               filters_.size() < 254) {
      if (state.filter == 0) {
        state.filter = std::uint8_t(filters_.size());
        state.surface = std::uint8_t(state.filter + facts.fluid);
        filters_.resize(std::size_t(state.surface) + 1);
      }
      const glm::vec3 color = glm::max(glm::vec3(mean), 1e-6f);
      filters_[state.filter] = {color, 1, glm::log(color)};
      if (facts.fluid) filters_[state.surface] = {color, kFluidHeight, glm::log(color)};
    }
  }
}

std::uint8_t SceneBuilder::filterAt(glm::ivec3 cell) const {
  const State& state = states_[input_.blocks.indexAt(cell)];
  const State& above = states_[input_.blocks.indexAt(cell + glm::ivec3(0, 1, 0))];
  return state.water && above.water ? state.filter : state.surface;
}

/// The box of all that is drawn or filters.
void SceneBuilder::measure() {
  if (placed_.empty()) return;
  glm::ivec3 low = placed_[0].cell, high = low;
  for (const PlacedQuad& placed : placed_) {
    low = glm::min(low, placed.cell);
    high = glm::max(high, placed.cell);
  }
  // A rim of air: rays from outside start before faces that lie in the last side of all.
  low_ = low - 1;
  size_ = high - low + 3;
}

void SceneBuilder::addCells() {
  std::size_t next = 0;
  for (int y = 0; y < size_.y; ++y) {
    for (int z = 0; z < size_.z; ++z) {
      for (int x = 0; x < size_.x; ++x) {
        const glm::ivec3 cell = low_ + glm::ivec3(x, y, z);
        const std::size_t first = next;
        while (next < placed_.size() && placed_[next].cell == cell) ++next;
        if (next == first && filterAt(cell) == 0) continue;
        offsets_.push_back(std::uint32_t(x + size_.x * (z + size_.z * y)));
        addCell(cell, first, next);
      }
    }
  }
}

void SceneBuilder::addCell(glm::ivec3 cell, std::size_t first, std::size_t end) {
  TraceCell& made = cells_.emplace_back();
  made.firstQuad = std::uint32_t(quads_.size());
  made.quadCount = std::uint16_t(std::min(end - first, std::size_t(65535)));
  made.filter = filterAt(cell);
  made.cube = first < end && input_.facts[input_.blocks.indexAt(cell)].fullOpaqueCube &&
              oneEachSide(placed_, first, end) &&
              !anyOf(placed_, first, end, [](const PlacedQuad& placed) {
                return !isUnitSide(placed) || placed.quad.alphaTested || placed.quad.translucent;
              });
  for (std::size_t i = first; i < first + made.quadCount; ++i) {
    TraceQuad quad = placed_[i].quad;
    const State& state = states_[quad.state];
    quad.corner -= glm::vec3(low_);
    quad.thin = state.thin;
    quad.water = state.water;
    quad.gloss = state.gloss;
    quad.blended = quad.translucent;
    quad.translucent = quad.translucent && !state.emits;
    quad.filters = quad.translucent && state.filter == 0;
    if (isUnitSide(placed_[i])) made.faces = std::uint8_t(made.faces | 1 << placed_[i].face);
    if (state.emits && state.ball == 0) {
      quad.lamp = std::uint32_t(lamps_.size());
      addLamp(cell, quad);
    }
    quads_.push_back(quad);
  }
  if (first < end) addBall(cell, states_[placed_[first].quad.state]);
}

void SceneBuilder::addBall(glm::ivec3 cell, const State& state) {
  if (state.ball == 0) return;
  LampFace ball;
  ball.quad = kNoQuad;
  ball.radius = state.ball;
  ball.cell = cell - low_;
  ball.corner = glm::vec3(cell - low_) + 0.5f;
  ball.radiance = state.radiance;
  ball.area = 4 * std::numbers::pi_v<float> * state.ball * state.ball;
  lamps_.push_back(ball);
}

/// Radiance of a lamp's faces over that of its cube: both send as much through the sides of the cell that are open. A side
/// of the cube on an opaque block or on the cube of another lamp gives nothing; light of faces does pass other lamps' cells.
float SceneBuilder::shareOfFaces(glm::ivec3 cell) {
  const std::uint32_t index = input_.blocks.indexAt(cell);
  const BlockFacts& facts = input_.facts[index];
  if (facts.fluid || facts.fullOpaqueCube) return 1;
  std::uint8_t open = 0, unshut = 0;
  for (int side = 0; side < 6; ++side) {
    const FaceDirection direction = FaceDirection(side);
    const std::uint32_t beside = input_.blocks.indexAt(cell + normalOf(direction));
    if ((input_.facts[beside].coveredFaces >> int(opposite(direction)) & 1) != 0) continue;
    unshut = std::uint8_t(unshut | 1 << side);
    const bool cube = states_[beside].emits && states_[beside].ball == 0;
    if (!cube) open = std::uint8_t(open | 1 << side);
  }
  const auto [share, fresh] = shares_.try_emplace({index, open, unshut}, 0.0f);
  if (fresh) share->second = float(std::popcount(open)) / shownArea(facts, input_.atlas, unshut);
  return share->second;
}

void SceneBuilder::addLamp(glm::ivec3 cell, const TraceQuad& quad) {
  LampFace face;
  face.cell = cell - low_;
  face.quad = std::uint32_t(quads_.size());
  face.corner = quad.corner;
  face.edgeU = quad.edgeU;
  face.edgeV = quad.edgeV;
  face.normal = quad.normal;
  face.radiance = states_[quad.state].radiance * shareOfFaces(cell);
  face.area = glm::length(quad.edgeU) * glm::length(quad.edgeV);
  lamps_.push_back(face);
}

}  // namespace

TraceScene buildTraceScene(const TraceSceneInput& input) { return SceneBuilder(input).build(); }

}  // namespace orris
