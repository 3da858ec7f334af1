#include <orris/world/random_room.h>

#include <fmt/core.h>

#include <array>
#include <charconv>

#include <orris/world/standing_camera.h>

namespace orris {
namespace {

constexpr int kMeadow = 5;  // blocks of grass around the walls

template <std::size_t N>
using Names = std::array<const char*, N>;

constexpr Names<16> kWalls = {"white_concrete", "light_gray_concrete", "gray_concrete", "stone",
                              "oak_planks", "spruce_planks", "bricks", "sandstone", "red_concrete",
                              "yellow_terracotta", "blue_concrete", "green_concrete",
                              "deepslate_bricks", "white_wool", "quartz_block", "netherrack"};
constexpr Names<8> kWindows = {"air", "air", "glass", "glass_pane", "red_stained_glass",
                               "light_blue_stained_glass", "yellow_stained_glass",
                               "lime_stained_glass_pane"};
constexpr Names<7> kLampBlocks = {"glowstone", "sea_lantern", "redstone_lamp[lit=true]", "shroomlight",
                                  "ochre_froglight", "verdant_froglight", "magma_block"};
constexpr Names<5> kSmallLamps = {"lantern", "soul_lantern", "torch", "soul_torch", "end_rod"};
constexpr Names<10> kFurniture = {"oak_stairs", "stone_slab", "oak_leaves", "oak_fence", "chest",
                                  "cobblestone_wall", "quartz_block", "hay_block", "glass",
                                  "iron_block"};
constexpr Names<4> kCarpets = {"red_carpet", "white_carpet", "blue_carpet", "moss_carpet"};
constexpr std::array<int, 7> kDays = {800, 1500, 2500, 4000, 6000, 9500, 11200};
constexpr int kMidnight = 18000;

/// Numbers from a seed: the finaliser of MurmurHash3 of a counter.
class RoomDice {
 public:
  explicit RoomDice(std::uint32_t seed) : state_(mixed(seed ^ 0x6f727269u)) {}
  int from(int low, int high) {  ///< both inclusive
    state_ += 0x9e3779b9u;
    return low + int((std::uint64_t(mixed(state_)) * std::uint64_t(high - low + 1)) >> 32);
  }
  bool in(int count) { return from(1, count) == 1; }  ///< once in so many
  template <class List>
  auto of(const List& list) {
    return list[std::size_t(from(0, int(list.size()) - 1))];
  }

 private:
  static std::uint32_t mixed(std::uint32_t h) {
    h = (h ^ h >> 16) * 0x85ebca6bu;
    h = (h ^ h >> 13) * 0xc2b2ae35u;
    return h ^ h >> 16;
  }
  std::uint32_t state_;
};

class RoomBuilder {
 public:
  explicit RoomBuilder(std::uint32_t seed) : dice_(seed) {}

  World build() {
    chooseSizes();
    addShell();
    if (dice_.in(3)) addDivider();
    const int openings = dice_.from(0, 4);
    for (int i = 0; i < openings; ++i) addOpening();
    if (dice_.in(5)) addRoofHole();
    if (dice_.in(5)) addPool(dice_.in(2) ? "lava" : "water");
    for (int i = dice_.from(0, 7); i > 0; --i) addFurniture();
    if (dice_.in(3)) addCarpet();
    const int time = dice_.in(4) ? kMidnight : dice_.of(kDays);
    const bool dark = time == kMidnight || !open_;
    for (int i = dice_.from(dark ? 2 : 0, dark ? 6 : 2); i > 0; --i) addLamp();
    return finished(time);
  }

 private:
  std::uint32_t block(const char* state) {
    return world_.blocks.paletteIndex(parseBlockState(state).value());
  }
  /// A free cell on the floor.
  glm::ivec3 spot() { return {dice_.from(low_.x, high_.x), low_.y, dice_.from(low_.z, high_.z)}; }
  bool isFree(glm::ivec3 p) const { return world_.blocks.indexAt(p) == 0; }

  void chooseSizes() {
    glm::ivec3 inside{dice_.from(4, 16), dice_.from(3, 8), dice_.from(4, 16)};
    if (dice_.in(5)) inside[dice_.in(2) ? 0 : 2] = dice_.from(17, 30);  // a hall
    low_ = {kMeadow + 1, 3, kMeadow + 1};
    high_ = low_ + inside - 1;
    const glm::ivec3 end = high_ + glm::ivec3(kMeadow + 2, 6, kMeadow + 2);
    world_.blocks = BlockWorld(glm::ivec3(0), end);
  }

  void addShell() {
    const glm::ivec3 end = world_.blocks.size() - 1;
    world_.blocks.fill({0, 0, 0}, {end.x, low_.y - 1, end.z}, block("dirt"));
    world_.blocks.fill({0, low_.y - 1, 0}, {end.x, low_.y - 1, end.z}, block("grass_block"));
    const std::uint32_t walls = block(dice_.of(kWalls));
    world_.blocks.fill(low_ - 1, high_ + 1, walls);
    if (dice_.in(2)) paintSide(dice_.from(0, 3));
    world_.blocks.fill({low_.x, low_.y - 1, low_.z}, {high_.x, low_.y - 1, high_.z},
                       block(dice_.of(kWalls)));
    if (dice_.in(2))
      world_.blocks.fill({low_.x, high_.y + 1, low_.z}, {high_.x, high_.y + 1, high_.z},
                         block(dice_.of(kWalls)));
    world_.blocks.fill(low_, high_, 0);
  }

  /// The box of a wall, one block thick: 0 west, 1 east, 2 north, 3 south.
  std::array<glm::ivec3, 2> side(int which) const {
    const int axis = which < 2 ? 0 : 2;
    glm::ivec3 from = low_, to = high_;
    from[axis] = to[axis] = which % 2 == 0 ? low_[axis] - 1 : high_[axis] + 1;
    return {from, to};
  }

  void paintSide(int which) {
    const auto [from, to] = side(which);
    world_.blocks.fill(from, to, block(dice_.of(kWalls)));
  }

  /// Across the longer way, with a gap to walk through.
  void addDivider() {
    const int axis = high_.x - low_.x > high_.z - low_.z ? 0 : 2, along = 2 - axis;
    glm::ivec3 from = low_, to = high_;
    from[axis] = to[axis] = dice_.from(low_[axis] + 1, high_[axis] - 1);
    world_.blocks.fill(from, to, block(dice_.of(kWalls)));
    from[along] = dice_.from(low_[along], high_[along]);
    to[along] = std::min(high_[along], from[along] + dice_.from(0, 2));
    to.y = std::min(high_.y, low_.y + dice_.from(1, 3));
    world_.blocks.fill(from, to, 0);
  }

  /// A window or a doorway.
  void addOpening() {
    const int which = dice_.from(0, 3), along = which < 2 ? 2 : 0;
    auto [from, to] = side(which);
    from[along] = dice_.from(low_[along], high_[along]);
    to[along] = std::min(high_[along], from[along] + dice_.from(0, 4));
    from.y = dice_.from(low_.y, high_.y - 1);
    to.y = std::min(high_.y, from.y + dice_.from(0, 3));
    const std::string window = dice_.of(kWindows);
    const bool pane = window.ends_with("_pane");
    const char* arms = along == 2 ? "[north=true,south=true]" : "[east=true,west=true]";
    world_.blocks.fill(from, to, block((window + (pane ? arms : "")).c_str()));
    open_ = true;
  }

  void addRoofHole() {
    const glm::ivec3 at = spot();
    const glm::ivec3 from{at.x, high_.y + 1, at.z};
    const glm::ivec3 to = glm::min(from + glm::ivec3(dice_.from(0, 3), 0, dice_.from(0, 3)),
                                   glm::ivec3(high_.x, high_.y + 1, high_.z));
    world_.blocks.fill(from, to, block(dice_.in(2) ? "air" : "glass"));
    open_ = true;
  }

  void addPool(const char* fluid) {
    const glm::ivec3 from = spot() - glm::ivec3(0, 1, 0);
    const glm::ivec3 to = glm::min(from + glm::ivec3(dice_.from(0, 3), 0, dice_.from(0, 3)),
                                   glm::ivec3(high_.x, from.y, high_.z));
    world_.blocks.fill(from, to, block(fluid));
  }

  bool standsOnFloor(glm::ivec3 p) const {
    const std::string& below = world_.blocks.at(p - glm::ivec3(0, 1, 0)).name;
    return isFree(p) && below != "minecraft:lava" && below != "minecraft:water";
  }

  void addFurniture() {
    const glm::ivec3 p = spot();
    const char* what = dice_.in(3) ? dice_.of(kWalls) : dice_.of(kFurniture);
    const int height = dice_.in(3) ? dice_.from(1, high_.y - low_.y + 1) : 1;
    if (standsOnFloor(p)) world_.blocks.fill(p, p + glm::ivec3(0, height - 1, 0), block(what));
  }

  void addCarpet() {
    const glm::ivec3 from = spot();
    const std::uint32_t carpet = block(dice_.of(kCarpets));
    const glm::ivec3 to = glm::min(from + glm::ivec3(dice_.from(0, 4), 0, dice_.from(0, 4)), high_);
    for (int z = from.z; z <= to.z; ++z)
      for (int x = from.x; x <= to.x; ++x)
        if (standsOnFloor({x, from.y, z})) world_.blocks.set({x, from.y, z}, carpet);
  }

  /// A block in a wall, the ceiling or on the floor; or a small lamp on the floor.
  void addLamp() {
    if (dice_.in(3)) {
      const glm::ivec3 p = spot();
      const char* lamp = dice_.of(kSmallLamps);
      if (standsOnFloor(p)) return world_.blocks.set(p, block(lamp));
    }
    auto [from, to] = side(dice_.from(0, 3));
    if (dice_.in(2)) {  // the ceiling
      from = {low_.x, high_.y + 1, low_.z};
      to = {high_.x, high_.y + 1, high_.z};
    }
    const glm::ivec3 at{dice_.from(from.x, to.x), dice_.from(from.y, to.y), dice_.from(from.z, to.z)};
    world_.blocks.set(at, block(dice_.of(kLampBlocks)));
  }

  World finished(int time) {
    world_.environment.time = time;
    glm::ivec3 eye = spot();
    for (int tries = 0; tries < 64 && !(standsOnFloor(eye) && isFree(eye + glm::ivec3(0, 1, 0))); ++tries)
      eye = spot();
    world_.blocks.fill(eye, eye + glm::ivec3(0, 1, 0), 0);
    world_.cameras = {standingCamera(world_.blocks, eye, "room")};
    return std::move(world_);
  }

  RoomDice dice_;
  World world_;
  glm::ivec3 low_{0}, high_{0};  ///< of the inside, both inclusive
  bool open_ = false;
};

}  // namespace

std::optional<std::uint32_t> randomRoomSeed(std::string_view name) {
  if (!name.starts_with(kRandomRoom)) return std::nullopt;
  const std::string_view digits = name.substr(kRandomRoom.size());
  std::uint32_t seed = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), seed);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return seed;
}

World randomRoom(std::uint32_t seed) {
  World world = RoomBuilder(seed).build();
  world.name = fmt::format("{}{}", kRandomRoom, seed);
  world.exercises = "a room that nobody has tuned for";
  return world;
}

}  // namespace orris
