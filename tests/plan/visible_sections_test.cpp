#include <orris/plan/frame/visible_sections.h>

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include <orris/world/mesh/block_faces.h>

namespace orris {
namespace {

/// Opaque cells in a box of sections.
class Rock {
 public:
  explicit Rock(glm::ivec3 sections) : sections_(sections), opaque_(std::size_t(sections.x * sections.y * sections.z)) {}
  void set(glm::ivec3 cell, bool opaque) { section(cell / 16).set(indexOfCell(cell % 16), opaque); }
  bool isOpaque(glm::ivec3 cell) { return section(cell / 16).test(indexOfCell(cell % 16)); }
  bool contains(glm::ivec3 cell) const {
    return glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) && glm::all(glm::lessThan(cell, sections_ * 16));
  }
  SectionGrid grid(glm::ivec3 origin = glm::ivec3(0)) const {
    SectionGrid grid{origin, sections_, {}};
    for (const OpaqueCells& cells : opaque_) grid.links.push_back(linksOf(cells));
    return grid;
  }

 private:
  OpaqueCells& section(glm::ivec3 s) { return opaque_[std::size_t((s.x * sections_.y + s.y) * sections_.z + s.z)]; }
  glm::ivec3 sections_;
  std::vector<OpaqueCells> opaque_;
};

/// Rock with caves: balls of air.
Rock caves(glm::ivec3 sections, int balls, std::mt19937& random) {
  Rock rock(sections);
  const glm::ivec3 cells = sections * 16;
  const auto upTo = [&](int n) { return int(random() % unsigned(n)); };
  std::vector<glm::ivec4> air;
  for (int i = 0; i < balls; ++i) air.emplace_back(upTo(cells.x), upTo(cells.y), upTo(cells.z), 3 + upTo(9));
  for (int x = 0; x < cells.x; ++x)
    for (int y = 0; y < cells.y; ++y)
      for (int z = 0; z < cells.z; ++z) {
        bool opaque = true;
        for (const glm::ivec4& ball : air) {
          const glm::ivec3 off = glm::ivec3(x, y, z) - glm::ivec3(ball);
          opaque = opaque && off.x * off.x + off.y * off.y + off.z * off.z > ball.w * ball.w;
        }
        rock.set({x, y, z}, opaque);
      }
  return rock;
}

/// Walks in steps of a thirtieth of a block: what it enters is seen, the opaque cell that ends it, too.
template <class Enter>
void walk(Rock& rock, glm::dvec3 place, const glm::dvec3& direction, Enter enter) {
  bool wasInside = false;
  for (int step = 0; step < 4000; ++step, place += direction * 0.03) {
    const glm::ivec3 cell(glm::floor(place));
    if (!rock.contains(cell)) {
      if (wasInside) return;
      continue;
    }
    wasInside = true;
    enter(cell);
    if (rock.isOpaque(cell)) return;
  }
}

TEST(VisibleSections, nothing_that_a_line_reaches_is_left_out) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  int leftOut = 0, looked = 0;
  for (int world = 0; world < 6; ++world) {
    const glm::ivec3 sections(4, 3, 4);
    Rock rock = caves(sections, 25, random);
    const SectionGrid grid = rock.grid();
    glm::dvec3 eye;
    do {
      eye = (glm::dvec3(unit(random), unit(random), unit(random)) * (world % 3 == 0 ? 1.4 : 1.0) + 1.0) * 0.5 * glm::dvec3(sections * 16);
    } while (rock.contains(glm::floor(eye)) && rock.isOpaque(glm::floor(eye)));
    const VisibleSections seen(grid, eye);
    for (int ray = 0; ray < 200; ++ray) {
      const glm::dvec3 direction = glm::normalize(glm::dvec3(unit(random), unit(random), unit(random)) + 1e-3);
      walk(rock, eye, direction, [&](glm::ivec3 cell) {
        ++looked;
        leftOut += !seen.contains(cell / 16 * 16);
      });
    }
  }
  EXPECT_GT(looked, 10000);
  EXPECT_EQ(leftOut, 0);
}

int countSeen(const VisibleSections& seen, const SectionGrid& grid) {
  int count = 0;
  for (int x = 0; x < grid.size.x; ++x)
    for (int y = 0; y < grid.size.y; ++y)
      for (int z = 0; z < grid.size.z; ++z) count += seen.contains(grid.origin + glm::ivec3(x, y, z) * 16);
  return count;
}

// 4 x 4 x 4 sections, of which the upper two layers are air; below a cave that has no way up.
TEST(VisibleSections, a_closed_cave_is_not_seen_from_above_nor_the_land_from_it) {
  Rock rock({4, 4, 4});
  for (int i = 0; i < 64 * 64 * 32; ++i) rock.set({i % 64, i / 4096, i / 64 % 64}, true);
  for (int i = 0; i < 40 * 8 * 40; ++i) rock.set({10 + i % 40, 10 + i / 1600, 10 + i / 40 % 40}, false);
  const SectionGrid grid = rock.grid({-32, -16, 0});
  const VisibleSections above(grid, {0.5, 40, 30});
  EXPECT_TRUE(above.contains({-32, 32, 48}));
  EXPECT_TRUE(above.contains({0, 0, 16})) << "the ground";
  EXPECT_FALSE(above.contains({0, -16, 16})) << "the cave";
  EXPECT_EQ(countSeen(above, grid), 48);
  const VisibleSections inside(grid, {0.5, -3, 30});
  EXPECT_TRUE(inside.contains({0, -16, 16}));
  EXPECT_FALSE(inside.contains({0, 32, 16}));
  EXPECT_LT(countSeen(inside, grid), 33);
}

// A shaft down, a tunnel, and another shaft up.
TEST(VisibleSections, a_line_does_not_turn_back) {
  Rock rock({3, 2, 1});
  for (int i = 0; i < 48 * 32 * 16; ++i) rock.set({i % 48, i / 768, i / 48 % 16}, true);
  for (int y = 4; y < 32; ++y)
    for (const int x : {6, 42}) rock.set({x, y, 8}, false);
  for (int x = 6; x <= 42; ++x) rock.set({x, 4, 8}, false);
  const SectionGrid grid = rock.grid();
  const VisibleSections seen(grid, {6.5, 20, 8.5});
  EXPECT_TRUE(seen.contains({0, 0, 0}));
  EXPECT_TRUE(seen.contains({32, 0, 0})) << "as far as sections tell";
  EXPECT_FALSE(seen.contains({32, 16, 0}));
}

// A pit in the land and a tunnel in the cliff, which rock parts.
TEST(VisibleSections, from_outside_each_side_that_looks_at_the_eye_is_entered) {
  Rock rock({2, 2, 1});
  for (int i = 0; i < 32 * 32 * 16; ++i) rock.set({i % 32, i / 512, i / 32 % 16}, true);
  for (int i = 0; i < 4; ++i) {
    rock.set({24, 31 - i, 8}, false);
    rock.set({i, 8, 8}, false);
  }
  const SectionGrid grid = rock.grid();
  const VisibleSections seen(grid, {-50, 90, 8});
  EXPECT_TRUE(seen.contains({16, 16, 0})) << "the pit";
  EXPECT_TRUE(seen.contains({0, 0, 0})) << "the tunnel";
  EXPECT_FALSE(seen.contains({16, 0, 0}));
}

TEST(VisibleSections, all_of_open_land_is_seen_from_outside) {
  const Rock rock({5, 1, 5});
  const SectionGrid grid = rock.grid({16, 0, -32});
  for (const glm::dvec3& eye : {glm::dvec3(-100, 300, 8), {56, 8, 8}, {500, -70, 900}})
    EXPECT_EQ(countSeen(VisibleSections(grid, eye), grid), 25);
}

}  // namespace
}  // namespace orris
