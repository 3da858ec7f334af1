#include <orris/world/blocks/block_facts.h>
#include <orris/world/blocks/shape_boxes.h>
#include <orris/world/blocks/neighbour_joins.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

namespace orris {
namespace {

/// Clockwise as seen from above.
constexpr std::array<std::string_view, 4> kAround = {"north", "east", "south", "west"};
constexpr std::array<glm::ivec3, 4> kSteps = {{{0, 0, -1}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}}};
constexpr std::array<FaceDirection, 4> kFaces = {FaceDirection::North, FaceDirection::East,
                                                 FaceDirection::South, FaceDirection::West};
constexpr glm::ivec3 kUp(0, 1, 0);

int acrossFrom(int side) { return (side + 2) % 4; }
int clockwise(int side) { return (side + 1) % 4; }
int counterClockwise(int side) { return (side + 3) % 4; }

bool saysOf(const BlockState& state, std::string_view property) {
  return state.properties.contains(std::string(property));
}

/// Index of kAround; -1: the state does not say.
int facingOf(const BlockState& state) {
  const auto found = std::ranges::find(kAround, state.property("facing"));
  return found == kAround.end() ? -1 : int(found - kAround.begin());
}

/// A world while its blocks are given what they lack.
class JoinedWorld {
 public:
  explicit JoinedWorld(BlockWorld& world) : world_(world) {}

  /// `wants`: is this a state that something may be missing of? `joined` gives the whole state of such a block.
  template <class Wants, class Joined>
  void change(const Wants& wants, const Joined& joined) {
    const std::size_t states = world_.palette().size();
    std::vector<bool> wanted(states);
    for (std::size_t i = 0; i < states; ++i) wanted[i] = wants(world_.palette()[i]);
    if (std::ranges::find(wanted, true) == wanted.end()) return;
    const auto isWanted = [&](std::uint32_t index) { return index < states && wanted[index]; };
    const glm::ivec3 low = world_.origin(), end = low + world_.size(), first = sectionOrigin(low);
    for (int y = first.y; y < end.y; y += kSectionSize)
      for (int z = first.z; z < end.z; z += kSectionSize)
        for (int x = first.x; x < end.x; x += kSectionSize) {
          const auto only = world_.uniformSection(glm::max(low, {x, y, z}));
          if (only && !isWanted(*only)) continue;
          changeSection(glm::max(low, {x, y, z}), glm::min(end, glm::ivec3(x, y, z) + kSectionSize),
                        isWanted, joined);
        }
  }

  const BlockState& at(glm::ivec3 p) const { return world_.at(p); }

  /// Which sides of the block's cube its boxes cover, by FaceDirection; 0 of what nothing is fastened to.
  std::uint8_t firmSides(glm::ivec3 p) {
    const std::uint32_t index = world_.indexAt(p);
    if (index >= firm_.size()) firm_.resize(world_.palette().size(), kUnknown);
    if (firm_[index] == kUnknown) firm_[index] = firmSidesOf(world_.palette()[index]);
    return std::uint8_t(firm_[index]);
  }

 private:
  static constexpr int kUnknown = -1;

  template <class Wanted, class Joined>
  void changeSection(glm::ivec3 low, glm::ivec3 end, const Wanted& isWanted, const Joined& joined) {
    for (int y = low.y; y < end.y; ++y)
      for (int z = low.z; z < end.z; ++z)
        for (int x = low.x; x < end.x; ++x) {
          const glm::ivec3 p(x, y, z);
          if (!isWanted(world_.indexAt(p))) continue;
          const BlockState state = joined(p, world_.at(p));
          // One more is kept for the water of waterlogged blocks.
          if (world_.palette().size() + 2 < kMaxPalette) world_.set(p, world_.paletteIndex(state));
        }
  }

  int firmSidesOf(const BlockState& state) const {
    constexpr std::string_view kLoose[] = {"minecraft:pumpkin", "minecraft:carved_pumpkin",
                                           "minecraft:jack_o_lantern", "minecraft:melon",
                                           "minecraft:barrier"};
    if (std::ranges::find(kLoose, state.name) != std::end(kLoose) ||
        state.name.ends_with("_leaves") || state.name.ends_with("shulker_box"))
      return 0;
    const BlockFacts facts = table_.factsOf(state);
    return facts.air || facts.fluid || facts.cross ? 0 : coveredFacesOf(facts.boxes);
  }

  BlockWorld& world_;
  BlockTable table_;
  std::vector<int> firm_;  // by palette index
};

enum class SideKind { None, Fence, Wall, Pane, Gate, Rail };

SideKind sideKindOf(const BlockState& state) {
  constexpr std::pair<std::string_view, SideKind> kEndings[] = {
      {"_fence", SideKind::Fence}, {"_wall", SideKind::Wall},       {"_pane", SideKind::Pane},
      {"_bars", SideKind::Pane},   {"_fence_gate", SideKind::Gate}, {":rail", SideKind::Rail},
      {"_rail", SideKind::Rail}};
  for (const auto& [ending, kind] : kEndings)
    if (state.name.ends_with(ending)) return kind;
  return SideKind::None;
}

bool lacksSides(const BlockState& state) {
  const SideKind kind = sideKindOf(state);
  if (kind == SideKind::Rail) return !saysOf(state, "shape");
  return kind != SideKind::None && kind != SideKind::Gate &&
         std::ranges::none_of(kAround, [&](std::string_view side) { return saysOf(state, side); });
}

// The game: FenceBlock, WallBlock and IronBarsBlock, "connectsTo" and "attachsTo".
bool meets(JoinedWorld& world, glm::ivec3 p, const BlockState& state, int side) {
  const BlockState& other = world.at(p + kSteps[std::size_t(side)]);
  const SideKind kind = sideKindOf(state), beside = sideKindOf(other);
  constexpr std::string_view kOwnKind = "minecraft:nether_brick_fence";
  if (kind == SideKind::Fence && beside == SideKind::Fence)
    return (state.name == kOwnKind) == (other.name == kOwnKind);
  if (kind == SideKind::Wall && (beside == SideKind::Wall || beside == SideKind::Pane)) return true;
  if (kind == SideKind::Pane && (beside == SideKind::Wall || beside == SideKind::Pane)) return true;
  // A gate stands across the way that it faces.
  if (kind != SideKind::Pane && beside == SideKind::Gate)
    return std::max(facingOf(other), 0) % 2 != side % 2;
  const auto towards = unsigned(kFaces[std::size_t(acrossFrom(side))]);
  return (world.firmSides(p + kSteps[std::size_t(side)]) >> towards & 1) != 0;
}

BlockState withSides(JoinedWorld& world, glm::ivec3 p, BlockState state) {
  const bool wall = sideKindOf(state) == SideKind::Wall;
  std::array<bool, 4> met{};
  for (int side = 0; side < 4; ++side) {
    met[std::size_t(side)] = meets(world, p, state, side);
    const char* yes = wall ? "low" : "true";
    state.properties[std::string(kAround[std::size_t(side)])] = met[std::size_t(side)] ? yes
                                                                : wall                 ? "none"
                                                                                       : "false";
  }
  if (!wall) return state;
  const bool straight = met[0] == met[2] && met[1] == met[3] && met[0] != met[1];
  state.properties["up"] = straight && world.at(p + kUp).name == "minecraft:air" ? "false" : "true";
  return state;
}

/// Does a rail lie on that side: beside, a block higher or a block lower?
struct RailBeside {
  bool there = false, higher = false;
};
RailBeside railBeside(const JoinedWorld& world, glm::ivec3 p, int side) {
  const auto isRail = [&](glm::ivec3 at) { return sideKindOf(world.at(at)) == SideKind::Rail; };
  const glm::ivec3 beside = p + kSteps[std::size_t(side)];
  const bool higher = isRail(beside + kUp);
  return {higher || isRail(beside) || isRail(beside - kUp), higher};
}

BlockState withShape(const JoinedWorld& world, glm::ivec3 p, BlockState state) {
  std::array<RailBeside, 4> rails;
  for (int side = 0; side < 4; ++side) rails[std::size_t(side)] = railBeside(world, p, side);
  const auto& [north, east, south, west] = rails;
  std::string shape =
      (east.there || west.there) && !north.there && !south.there ? "east_west" : "north_south";
  const bool curves =
      state.name == "minecraft:rail" && north.there != south.there && east.there != west.there;
  if (curves) {
    shape = std::string(north.there ? "north_" : "south_") + (east.there ? "east" : "west");
  } else {
    for (int side = shape == "east_west" ? 1 : 0; side < 4; side += 2)
      if (rails[std::size_t(side)].higher)
        shape = "ascending_" + std::string(kAround[std::size_t(side)]);
  }
  state.properties["shape"] = shape;
  return state;
}

bool isStairs(const BlockState& state) {
  return state.name.ends_with("_stairs") && facingOf(state) >= 0;
}

bool isTurnedStairs(const BlockState& other, const BlockState& stairs) {
  return isStairs(other) && other.property("half") == stairs.property("half") &&
         facingOf(other) % 2 != facingOf(stairs) % 2;
}

// The game: StairBlock.getStairsShape.
BlockState withCorner(const JoinedWorld& world, glm::ivec3 p, BlockState state) {
  const int facing = facingOf(state);
  const auto continues = [&](int side) {
    const BlockState& other = world.at(p + kSteps[std::size_t(side)]);
    return isStairs(other) && facingOf(other) == facing &&
           other.property("half") == state.property("half");
  };
  const BlockState& before = world.at(p + kSteps[std::size_t(facing)]);
  const BlockState& behind = world.at(p + kSteps[std::size_t(acrossFrom(facing))]);
  const auto leftOr = [&](int side) { return side == counterClockwise(facing) ? "left" : "right"; };
  std::string shape = "straight";
  if (isTurnedStairs(before, state) && !continues(acrossFrom(facingOf(before))))
    shape = std::string("outer_") + leftOr(facingOf(before));
  else if (isTurnedStairs(behind, state) && !continues(facingOf(behind)))
    shape = std::string("inner_") + leftOr(facingOf(behind));
  state.properties["shape"] = shape;
  return state;
}

BlockState withOtherHalf(const JoinedWorld& world, glm::ivec3 p, BlockState state) {
  const bool upper = state.property("half") == "upper";
  const BlockState& other = world.at(upper ? p - kUp : p + kUp);
  if (other.property("half") != (upper ? "lower" : "upper")) return state;
  // The upper half of a plant does not know which one it is.
  if (!state.name.ends_with("_door")) {
    if (upper && !other.name.ends_with("_door")) state.name = other.name;
    return state;
  }
  if (other.name == state.name)
    state.properties.insert(other.properties.begin(), other.properties.end());
  return state;
}

BlockState asChest(const JoinedWorld& world, glm::ivec3 p, BlockState state) {
  const int facing = std::max(facingOf(state), 0);
  const auto isOther = [&](int side) {
    const BlockState& other = world.at(p + kSteps[std::size_t(side)]);
    return other.name == state.name && std::max(facingOf(other), 0) == facing;
  };
  const bool left = isOther(clockwise(facing)), right = isOther(counterClockwise(facing));
  state.properties["type"] = left ? "left" : right ? "right" : "single";
  return state;
}

bool isSplit(const BlockState& state) {
  const std::string_view half = state.property("half");
  return half == "lower" || half == "upper";
}

bool lacksPart(const BlockState& state) {
  if (isStairs(state)) return !saysOf(state, "shape");
  if (state.name == "minecraft:chest" || state.name == "minecraft:trapped_chest")
    return !saysOf(state, "type");
  if (!isSplit(state)) return false;
  return !state.name.ends_with("_door") || !saysOf(state, "facing") || !saysOf(state, "hinge");
}

}  // namespace

void joinSides(BlockWorld& world) {
  JoinedWorld joined(world);
  joined.change(lacksSides, [&](glm::ivec3 p, const BlockState& state) {
    return sideKindOf(state) == SideKind::Rail ? withShape(joined, p, state)
                                               : withSides(joined, p, state);
  });
}

void completeParts(BlockWorld& world) {
  JoinedWorld joined(world);
  joined.change(lacksPart, [&](glm::ivec3 p, const BlockState& state) {
    if (isStairs(state)) return withCorner(joined, p, state);
    return isSplit(state) ? withOtherHalf(joined, p, state) : asChest(joined, p, state);
  });
}

}  // namespace orris
