// Real blocks: partial shapes, holes, thin leaves, tinted glass, water, lamps.
#include "block_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cube_scene.h"

namespace orris {
namespace {

using test::BlockScene;
using test::Estimate;

// A listed white lamp, so that its colour is not that of its texture (lamp_color, digit 6).
constexpr int kWhiteLamp = 106;
const glm::vec3 kWhiteLampColor(1.0f, 0.92f, 0.84f);

/// All white, with the holes there are; lamps black.
void whiten(BlockAtlas& atlas) {
  for (const auto& [name, tile] : atlas.tiles) {
    const int x0 = int(tile.min.x * float(atlas.albedo.width) + 0.5f);
    const int y0 = int(tile.min.y * float(atlas.albedo.height) + 0.5f);
    for (int y = y0; y < y0 + 16; ++y)
      for (int x = x0; x < x0 + 16; ++x) {
        std::uint8_t* texel = atlas.albedo.at(x, y);
        texel[0] = texel[1] = texel[2] = name == "sea_lantern" ? 0 : 255;
      }
  }
}

const char* const kFurnace = R"({"size": [9, 7, 9], "blocks": [
  {"hollow": "sea_lantern", "min": [0, 0, 0], "max": [8, 6, 8]},
  {"block": "stone_brick_stairs[facing=north]", "at": [2, 1, 2]},
  {"block": "stone_brick_stairs[facing=east,half=top]", "at": [3, 1, 2]},
  {"block": "oak_slab[type=top]", "at": [4, 2, 4]},
  {"block": "oak_slab[type=bottom]", "at": [5, 1, 4]},
  {"block": "oak_fence[east=true]", "at": [5, 1, 6]},
  {"block": "oak_leaves", "at": [3, 2, 5]}, {"block": "oak_leaves", "at": [6, 4, 3]},
  {"block": "poppy", "at": [6, 1, 2]}, {"block": "fern", "at": [2, 1, 6]},
  {"block": "glass", "at": [6, 3, 6]}, {"block": "glass_pane[north=true]", "at": [6, 1, 5]},
  {"block": "stone", "at": [4, 1, 5]}],
  "cameras": [{"name": "a", "position": [4.5, 4.5, 4.5], "yaw": 0, "pitch": 0, "fov": 90}]})";

LightingInput lampsOf(const char* strength) {
  LightingInput lighting;
  lighting.options = {{"EMISSION_STRENGTH", strength}};
  return lighting;
}

TraceCamera looking(glm::dvec3 position, glm::vec3 direction, int size) {
  TraceCamera camera;
  camera.width = camera.height = size;
  camera.position = position;
  const glm::vec3 forward = glm::normalize(direction);
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0.01f, 1, 0.02f)));
  const glm::vec3 up = glm::cross(right, forward);
  camera.modelViewInverse = glm::mat4(glm::vec4(right, 0), glm::vec4(up, 0), glm::vec4(-forward, 0),
                                      glm::vec4(0, 0, 0, 1));
  camera.projectionInverse = glm::mat4(0);
  camera.projectionInverse[0][0] = camera.projectionInverse[1][1] = 1;
  camera.projectionInverse[3] = glm::vec4(0, 0, -1, 1);
  return camera;
}

// Leaves show a carpet beside them their sides, so rays begin within it, over a floor whose top it hides.
TEST(HiddenSides, give_rays_that_begin_within_a_carpet_no_light_and_a_place) {
  const BlockScene scene = test::blockScene(
      R"({"size": [9, 6, 9], "blocks": [{"box": "stone", "min": [0,0,0], "max": [8,0,8]},
        {"box": "white_carpet", "min": [3,1,3], "max": [5,1,5]}, {"block": "sea_lantern", "at": [4,4,4]}],
        "cameras": [{"name": "a", "position": [2, 2, 8], "yaw": 180, "pitch": 0, "fov": 60}]})",
      {}, lampsOf("16"));
  const PathTracer tracer(scene.scene, {}, {});
  const glm::ivec3 cell = glm::ivec3(4, 1, 4) - scene.scene.origin;
  TraceSurface within;
  within.position = glm::vec3(cell) + glm::vec3(0, 0.03f, 0.5f);
  within.normal = glm::vec3(1, 0, 0);
  within.cell = cell;
  int hidden = 0;
  for (std::uint32_t i = 0; i < 200; ++i) {
    SampleRandom random(9, 1, i);
    RayCounts counts;
    std::vector<Ray> rays;
    counts.record = &rays;
    EXPECT_EQ(tracer.incoming(within, random, counts), glm::vec3(0));
    ASSERT_FALSE(rays.empty());
    for (const Ray& ray : rays) {
      const RayHit hit = scene.scene.grid.intersect(ray);
      hidden += hit.quad == kHiddenQuad;
      EXPECT_TRUE(std::isfinite(hit.at.x) && std::isfinite(hit.at.y));
    }
  }
  EXPECT_GT(hidden, 0);
}

// Whatever the shape, a white thing in a room that glows evenly looks like the glow; leaves and
// plants, which let light through, too.
TEST(BlockFurnace, hides_every_shape) {
  const BlockScene scene = test::blockScene(kFurnace,
                                            {{"minecraft:sea_lantern", kWhiteLamp},
                                             {"minecraft:oak_leaves", 11},
                                             {"minecraft:poppy", 10},
                                             {"minecraft:fern", 10}},
                                            lampsOf("1"), whiten);
  int seen = 0;
  double squares = 0, noise = 0;
  for (const glm::vec3& direction : {glm::vec3(0, -1, 0.2f),
                                     {1, -0.6f, 0},
                                     {-1, -0.5f, 0.3f},
                                     {0, -0.3f, -1},
                                     {0.5f, -0.6f, 1}}) {
    const TraceCamera camera = looking({4.5, 4.5, 4.5}, direction, 32);
    const PathTracer tracer(scene.scene, camera, {});
    RayCounts counts;
    for (int i = 0; i < 32 * 32; ++i) {
      const PixelView view = tracer.view(i % 32, i / 32, counts);
      if (view.layers.empty() || view.layers[0].surface.albedo == glm::vec3(0)) continue;
      const Estimate result = test::estimate(400, [&](std::uint32_t sample) {
        SampleRandom random(9, std::uint32_t(i), sample);
        return double(tracer.sample(view, random, counts).g) / kWhiteLampColor.g;
      });
      ++seen;
      squares += std::pow(result.mean - 1, 2);
      noise += result.error * result.error;
      EXPECT_NEAR(result.mean, 1, 6 * result.error + 1e-3)
          << scene.world.blocks.palette()[scene.scene.grid.quad(view.layers[0].surface.quad).state]
                 .toString()
          << " at pixel " << i;
    }
  }
  EXPECT_GT(seen, 500);
  EXPECT_LT(squares, 1.5 * noise + 1e-3);
}

/// Two rooms, a lamp in one; the wall between them has the block under test in its hole.
std::string tunnel(const std::string& block) {
  return R"({"size": [5, 5, 12], "blocks": [
    {"hollow": "black_concrete", "min": [0, 0, 0], "max": [4, 4, 11]},
    {"box": "sea_lantern", "min": [1, 1, 0], "max": [3, 3, 0]},
    {"box": ")" +
         block + R"(", "min": [1, 1, 5], "max": [3, 3, 5]}],
    "cameras": [{"name": "a", "position": [2.5, 2.5, 8], "yaw": 180, "pitch": 0, "fov": 60}]})";
}

/// Light that arrives along one line through the block.
glm::vec3 passed(const std::string& block, int id) {
  const BlockScene scene = test::blockScene(
      tunnel(block), {{"minecraft:sea_lantern", kWhiteLamp}, {"minecraft:" + block, id}},
      lampsOf("1"));
  const VoxelGrid& grid = scene.scene.grid;
  Ray ray;
  ray.origin = {2.4f, 2.6f, 9};
  ray.cell = {2, 2, 9};
  ray.direction = withoutZeros({0, 0, -1});
  const RayHit hit = grid.intersect(ray);
  if (hit.quad == kNoQuad || grid.quad(hit.quad).lamp == kNoQuad) return glm::vec3(0);
  return hit.filter;
}

TEST(Translucent, blocks_tint_what_passes_them) {
  const glm::vec3 red = passed("red_stained_glass", 21), blue = passed("blue_stained_glass", 21);
  EXPECT_GT(red.r, 3 * red.b);
  EXPECT_GT(blue.b, 3 * blue.r);
  EXPECT_GT(red.r, 0.2f);
  EXPECT_LT(red.r, 1);
  EXPECT_EQ(passed("air", -1), glm::vec3(1));
  EXPECT_EQ(passed("stone", -1), glm::vec3(0));
}

TEST(Translucent, panes_tint_as_their_faces_do) {
  const glm::vec3 red = passed("red_stained_glass_pane[east=true,west=true]", 12);
  EXPECT_GT(red.r, 3 * red.b);
}

// Within a wall of panes it passes from one to the next, and meets neither edges nor ends.
TEST(Translucent, panes_tint_once_however_aslant_light_crosses_them) {
  const char* pane = "red_stained_glass_pane[east=true,west=true]";
  const BlockScene scene = test::blockScene(
      tunnel(pane), {{"minecraft:sea_lantern", kWhiteLamp}, {"minecraft:red_stained_glass_pane", 25}},
      lampsOf("1"));
  const float once = passed("red_stained_glass", 21).b;  // a block of the same texture, which has one colour
  SampleRandom random(1, 2, 3);
  for (int i = 0; i < 4000; ++i) {
    const glm::vec2 from = 1.01f + 2.98f * random.pair(), to = 1.01f + 2.98f * random.pair();
    Ray ray;
    ray.origin = glm::vec3(from, 5.7f) - glm::vec3(scene.scene.origin);
    ray.cell = glm::ivec3(ray.origin);
    ray.direction = withoutZeros(glm::normalize(glm::vec3(to - from, -0.4f)));
    EXPECT_NEAR(scene.scene.grid.intersect(ray).filter.b, once, 0.02f * once) << i;
  }
}

// One block of it lets its colour through: two blocks let the square through.
TEST(Translucent, depth_counts) {
  const std::string two = R"({"size": [5, 5, 12], "blocks": [
    {"hollow": "black_concrete", "min": [0, 0, 0], "max": [4, 4, 11]},
    {"box": "sea_lantern", "min": [1, 1, 0], "max": [3, 3, 0]},
    {"box": "water", "min": [1, 1, 4], "max": [3, 3, 5]}],
    "cameras": [{"name": "a", "position": [2.5, 2.5, 8], "yaw": 180, "pitch": 0, "fov": 60}]})";
  const BlockScene scene =
      test::blockScene(two, {{"minecraft:sea_lantern", kWhiteLamp}}, lampsOf("1"));
  Ray ray;
  ray.origin = {2.4f, 2.6f, 9};
  ray.cell = {2, 2, 9};
  ray.direction = withoutZeros({0, 0, -1});
  const glm::vec3 twice = scene.scene.grid.intersect(ray).filter, once = passed("water", 20);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(twice[c], once[c] * once[c], 1e-4f);
}

/// Power of a lone lamp: what all its faces send out.
float powerOf(const std::string& block, int id) {
  const BlockScene scene = test::blockScene(
      R"({"size": [3, 3, 3], "blocks": [{"block": ")" + block + R"(", "at": [1, 1, 1]}],
      "cameras": [{"name": "a", "position": [2, 2, 8], "yaw": 180, "pitch": 0, "fov": 60}]})",
      {{"minecraft:" + block.substr(0, block.find('[')), id}}, lampsOf("16"));
  float power = 0;
  for (const LampFace& face : scene.scene.lamps.faces()) power += face.radiance.r * face.area;
  return power;
}

// The pack's rays take a lamp for a cube, a small one for a ball of radius 1/4, 5 times as bright.
TEST(Lamps, have_the_power_of_the_shape_the_pack_gives_them) {
  EXPECT_NEAR(powerOf("sea_lantern", kWhiteLamp), 6 * 16, 1e-3f);
  EXPECT_NEAR(powerOf("torch", 201), 5 * 4 * 3.14159265f / 16 * 16 * 14 * 14 / 225, 1e-3f);
  EXPECT_GT(powerOf("lantern", 201), 40);
}

// A ball of radiance L and radius r gives a plane L (r / d)^2 cos, while it is whole above it. The
// lantern's own faces and whatever is behind it are no obstacles; a stone between is one.
TEST(Lamps, small_ones_light_as_balls) {
  const auto lit = [](const std::string& between, glm::ivec3 floor) {
    const BlockScene scene = test::blockScene(
        R"({"size": [9, 6, 9], "blocks": [{"box": "black_concrete", "min": [0,0,0], "max": [8,0,8]},
        {"block": "lantern", "at": [4,3,4]}, {"block": ")" +
            between + R"(", "at": [4,2,4]}],
        "cameras": [{"name": "a", "position": [2, 2, 8], "yaw": 180, "pitch": 0, "fov": 60}]})",
        {{"minecraft:lantern", 206}}, lampsOf("16"));
    TraceSettings settings;
    settings.bounces = 1;
    const PathTracer tracer(scene.scene, {}, settings);
    RayCounts counts;
    const glm::ivec3 cell = floor - scene.scene.origin;
    return test::estimate(20000, [&](std::uint32_t i) {
      SampleRandom random(9, 1, i);
      const TraceSurface at = test::surfaceOn(cell, FaceDirection::Up, {0.5f, 0.5f});
      return double(tracer.incoming(at, random, counts).r);
    });
  };
  for (const glm::ivec3 floor : {glm::ivec3(4, 0, 4), {7, 0, 4}, {1, 0, 0}}) {
    const Estimate found = lit("air", floor);
    const double squared =
        2.5 * 2.5 + (floor.x - 4) * (floor.x - 4) + (floor.z - 4) * (floor.z - 4);
    const double expected = 5 * 16 / 16.0 / squared * 2.5 / std::sqrt(squared);
    EXPECT_NEAR(found.mean, expected, 0.003 * expected + 4 * found.error) << floor.x;
    EXPECT_GT(found.mean, 0.01);
  }
  EXPECT_LT(lit("stone", {4, 0, 4}).mean, 1e-3);
}

// Both of what a floor gets and of what a mirror shows.
TEST(Lamps, small_ones_are_tinted_by_glass_before_them_alone) {
  const auto light = [](const std::string& below, const std::string& above, bool mirrored) {
    const BlockScene scene = test::blockScene(
        R"({"size": [9, 6, 9], "blocks": [{"box": "black_concrete", "min": [0,0,0], "max": [8,0,8]},
        {"block": "torch", "at": [4,3,4]}, {"block": ")" +
            below + R"(", "at": [4,2,4]}, {"block": ")" + above + R"(", "at": [4,4,4]}],
        "cameras": [{"name": "a", "position": [2, 2, 8], "yaw": 180, "pitch": 0, "fov": 60}]})",
        {{"minecraft:torch", 206}, {"minecraft:red_stained_glass", 21}}, lampsOf("16"));
    TraceSettings settings;
    settings.bounces = 1;
    const PathTracer tracer(scene.scene, {}, settings);
    RayCounts counts;
    const glm::vec3 up = withoutZeros(glm::vec3(0, 1, 0));
    glm::vec3 sum(0);
    for (std::uint32_t i = 0; i < 200; ++i) {
      SampleRandom random(9, 1, i);
      // Below the ball, beside its rod.
      const TraceSurface at =
          test::surfaceOn(glm::ivec3(4, 0, 4) - scene.scene.origin, FaceDirection::Up, {0.7f, 0.5f});
      sum += tracer.incoming(at, random, counts, mirrored ? &up : nullptr);
    }
    return sum;
  };
  for (const bool mirrored : {false, true}) {
    const glm::vec3 plain = light("air", "air", mirrored);
    const glm::vec3 before = light("red_stained_glass", "air", mirrored);
    EXPECT_EQ(light("air", "red_stained_glass", mirrored), plain) << mirrored;
    EXPECT_GT(plain.b, 0);
    EXPECT_LT(before.b / before.r, 0.5f * plain.b / plain.r);
  }
}

TEST(Lamps, are_drawn_with_the_probability_they_tell) {
  test::Cubes cubes = test::roomOf({20, 6, 20}, {});
  for (int i = 0; i < 90; ++i)
    cubes[{1 + i % 10 * 2, 1 + i / 10 % 3, 1 + i / 30 * 7}].radiance =
        glm::vec3(1.0f + float(i % 7));
  const TraceScene scene = test::sceneOf(cubes);
  for (const glm::ivec3 cell : {glm::ivec3(2, 1, 2), {11, 5, 13}}) {
    double sum = 0;
    std::vector<double> drawn(scene.lamps.faces().size(), 0);
    constexpr int kDraws = 400000;
    for (int i = 0; i < kDraws; ++i) {
      const LampDraw draw = scene.lamps.draw(cell, (float(i) + 0.5f) / kDraws);
      const auto index = std::size_t(draw.face - scene.lamps.faces().data());
      drawn[index] += 1.0 / kDraws;
      ASSERT_NEAR(draw.probability, scene.lamps.probability(cell, std::uint32_t(index)), 1e-6);
    }
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const double stated = scene.lamps.probability(cell, std::uint32_t(i));
      sum += stated;
      ASSERT_NEAR(drawn[i], stated, 1e-4) << i;
    }
    EXPECT_NEAR(sum, 1, 1e-4);
  }
}

}  // namespace
}  // namespace orris
