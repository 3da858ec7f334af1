// Lamps of every shape: what they send out, by theory and by a search through all quads.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "block_scene.h"
#include "cube_scene.h"

namespace orris {
namespace {

using test::BlockScene;
using test::Estimate;

constexpr int kSide = 7;         // of the room, inside
constexpr int kListedLamp = 106;  // listed, so that its colour is not that of its texture
constexpr double kWhiteGreen = 0.92;
constexpr int kGreyByte = 188;

struct Lamp {
  const char* block;
  int level;
};
void PrintTo(const Lamp& lamp, std::ostream* out) { *out << lamp.block; }

LightingInput strengthOne() {
  LightingInput lighting;
  lighting.options = {{"EMISSION_STRENGTH", "1"}};
  return lighting;
}

std::string nameOf(const std::string& block) { return "minecraft:" + block.substr(0, block.find('[')); }

/// A black room with one lamp in its middle.
BlockScene roomWith(const std::string& block) {
  const std::string json = R"({"size": [9, 9, 9], "blocks": [
      {"hollow": "black_concrete", "min": [0, 0, 0], "max": [8, 8, 8]},
      {"block": ")" + block + R"(", "at": [4, 4, 4]}],
      "cameras": [{"name": "a", "position": [2, 2, 2], "yaw": 0, "pitch": 0, "fov": 60}]})";
  return test::blockScene(json, {{nameOf(block), kListedLamp}}, strengthOne());
}

/// A point of the room's walls, all alike.
TraceSurface onWalls(SampleRandom& random, const TraceScene& scene) {
  const int face = int(random.one() * 6), axis = face / 2 == 0 ? 1 : face / 2 == 1 ? 2 : 0;
  const bool upper = (face & 1) != 0;
  const glm::vec2 at = random.pair() * float(kSide);
  glm::ivec3 cell(0);
  cell[axis] = upper ? 0 : kSide + 1;
  cell[(axis + 1) % 3] = 1 + int(at.x);
  cell[(axis + 2) % 3] = 1 + int(at.y);
  return test::surfaceOn(cell - scene.origin, FaceDirection(face), glm::fract(at));
}

/// The lamp's radiance along a ray by a search through all quads, holes left out; else 0.
double searched(const TraceScene& scene, const Ray& ray) {
  float nearest = std::numeric_limits<float>::infinity();
  double found = 0;
  for (std::uint32_t i = 1; i < scene.grid.quads().size(); ++i) {
    const TraceQuad& q = scene.grid.quad(i);
    const float slope = glm::dot(q.normal, ray.direction);
    if (slope >= 0) continue;
    const float t = glm::dot(q.normal, q.corner - ray.origin) / slope;
    const glm::vec3 from = ray.origin + ray.direction * t - q.corner;
    const glm::vec2 at(glm::dot(from, q.edgeU) / glm::dot(q.edgeU, q.edgeU),
                       glm::dot(from, q.edgeV) / glm::dot(q.edgeV, q.edgeV));
    if (!(t > 1e-4f && t < nearest && at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1)) continue;
    if (q.alphaTested && scene.grid.texel(q, at).a < kAlphaTest) continue;
    nearest = t;
    found = q.lamp == kNoQuad ? 0 : double(scene.lamps.face(q.lamp).radiance.g);
  }
  return found;
}

class LampShape : public testing::TestWithParam<Lamp> {
 public:
  /// Of what arrives at the walls, found by the tracer.
  static Estimate traced(const TraceScene& scene) {
    TraceSettings settings;
    settings.bounces = 1;
    const PathTracer tracer(scene, {}, settings);
    RayCounts counts;
    return test::estimate(100000, [&](std::uint32_t i) {
      SampleRandom random(3, 0, i);
      const TraceSurface at = onWalls(random, scene);
      return double(tracer.incoming(at, random, counts).g);
    });
  }
};

// All faces together send out what the pack's cube does, whatever hides some of them from others.
TEST_P(LampShape, sends_out_the_power_of_its_cube) {
  const double radiance = kWhiteGreen * GetParam().level * GetParam().level / 225.0;
  const BlockScene scene = roomWith(GetParam().block);
  const Estimate result = traced(scene.scene);
  const double expected = 6 * radiance / (6.0 * kSide * kSide);
  EXPECT_NEAR(result.mean, expected, 0.005 * expected + 4 * result.error);
  EXPECT_LT(result.error, 0.01 * expected);
}

// What neighbours cover of its cube gives nothing, and its planes no more than the rest.
TEST(CoveredLamps, send_out_the_power_of_their_open_sides) {
  const BlockScene scene = test::blockScene(
      R"({"size": [9, 9, 9], "blocks": [
      {"hollow": "black_concrete", "min": [0, 0, 0], "max": [8, 8, 8]},
      {"box": "black_concrete", "min": [3, 3, 4], "max": [5, 5, 4]},
      {"block": "nether_portal[axis=x]", "at": [4, 4, 4]}],
      "cameras": [{"name": "a", "position": [2, 2, 2], "yaw": 0, "pitch": 0, "fov": 60}]})",
      {{"minecraft:nether_portal", kListedLamp}}, strengthOne());
  const Estimate result = LampShape::traced(scene.scene);
  const double expected = 2 * kWhiteGreen * 11 * 11 / 225 / (6.0 * kSide * kSide);
  EXPECT_NEAR(result.mean, expected, 0.005 * expected + 4 * result.error);
  EXPECT_LT(result.error, 0.02 * expected);
}

// In the middle of a wall of portals each shows the radiance of its cube.
TEST(CoveredLamps, walls_of_portals_are_as_bright_as_walls_of_cubes) {
  const BlockScene scene = test::blockScene(
      R"({"size": [9, 9, 9], "blocks": [
      {"box": "nether_portal[axis=x]", "min": [1, 1, 4], "max": [7, 7, 4]}],
      "cameras": [{"name": "a", "position": [2, 2, 2], "yaw": 0, "pitch": 0, "fov": 60}]})",
      {{"minecraft:nether_portal", kListedLamp}}, strengthOne());
  int seen = 0;
  for (const LampFace& face : scene.scene.lamps.faces()) {
    if (face.cell + scene.scene.origin != glm::ivec3(4)) continue;
    EXPECT_NEAR(face.radiance.g, kWhiteGreen * 11 * 11 / 225, 0.005);
    ++seen;
  }
  EXPECT_EQ(seen, 2);
}

TEST_P(LampShape, lights_as_a_search_through_all_quads_finds) {
  const BlockScene scene = roomWith(GetParam().block);
  const Estimate found = traced(scene.scene);
  const Estimate expected = test::estimate(60000, [&](std::uint32_t i) {
    SampleRandom random(5, 1, i);
    const TraceSurface at = onWalls(random, scene.scene);
    const glm::vec2 u = random.pair();
    const float r = std::sqrt(u.x), angle = 6.2831853f * u.y;
    const glm::vec3 side = glm::abs(at.normal.y) > 0.5f ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    Ray ray;
    ray.origin = at.position;
    ray.direction = withoutZeros(at.normal * std::sqrt(1 - u.x) + r * std::cos(angle) * side +
                                 r * std::sin(angle) * glm::cross(side, at.normal));
    return searched(scene.scene, ray);
  });
  EXPECT_NEAR(found.mean, expected.mean, 4 * std::hypot(found.error, expected.error));
  EXPECT_GT(expected.mean, 10 * expected.error);
}

INSTANTIATE_TEST_SUITE_P(
    Blocks, LampShape,
    testing::Values(Lamp{"fire", 15}, Lamp{"soul_fire", 10}, Lamp{"nether_portal[axis=x]", 11},
                    Lamp{"end_portal", 15}, Lamp{"magma_block", 3}, Lamp{"glowstone", 15}),
    [](const auto& tested) {
      const std::string block = tested.param.block;
      return block.substr(0, block.find('['));
    });

// Of light the room has no other, so that what is behind the portal adds nothing. It stops rays, but is drawn as glass is.
TEST(SeenLamps, portals_show_their_texture_times_their_level_and_what_is_behind) {
  const BlockScene portal = roomWith("nether_portal[axis=x]");
  TraceCamera camera;
  camera.width = camera.height = 1;
  camera.position = {4.4, 4.3, 7};
  camera.projectionInverse = glm::mat4(0);
  camera.projectionInverse[0][0] = camera.projectionInverse[1][1] = 0.01f;
  camera.projectionInverse[3] = glm::vec4(0, 0, -1, 1);
  RayCounts counts;
  const PixelView view = PathTracer(portal.scene, camera, {}).view(0, 0, counts);
  ASSERT_EQ(view.layers.size(), 2u);
  const PixelView::Layer& seen = view.layers.front();
  const glm::vec3 shown = seen.weight * seen.surface.albedo * portal.scene.emissionScale[11];
  EXPECT_GT(shown.b, .1f);
  EXPECT_NEAR(seen.weight.b + view.layers.back().weight.b, 1, 1e-5);
  EXPECT_GT(view.layers.back().weight.b, .1f);
  for (int c = 0; c < 3; ++c) EXPECT_FLOAT_EQ(view.constant[c], shown[c]) << c;
}

/// Share of a hemisphere's cosine that a rectangle fills, from above its corner at height 1.
double cornerShare(double a, double b) {
  const double p = std::sqrt(1 + a * a), q = std::sqrt(1 + b * b);
  return (a / p * std::atan(b / p) + b / q * std::atan(a / q)) / 6.283185307179586;
}

// What a lamp gives is what leaves it. An end rod reaches out of the ball that gives its light, and planes of fire cross.
TEST(LampOwnFaces, get_none_of_their_light) {
  for (const auto& [block, id] : {std::pair{"end_rod", 206}, {"fire", kListedLamp}}) {
    const BlockScene scene = test::blockScene(
        fmt::format(R"({{"size": [9, 9, 9], "blocks": [
        {{"hollow": "black_concrete", "min": [0, 0, 0], "max": [8, 8, 8]}},
        {{"block": "{}", "at": [4, 1, 4]}}],
        "cameras": [{{"name": "a", "position": [2, 2, 2], "yaw": 0, "pitch": 0, "fov": 60}}]}})", block),
        {{nameOf(block), id}}, strengthOne());
    TraceSettings settings;
    settings.bounces = 1;
    const PathTracer tracer(scene.scene, {}, settings);
    RayCounts counts;
    const auto lightAt = [&](const TraceSurface& at) {
      return test::estimate(500, [&](std::uint32_t i) {
               SampleRandom random(3, 0, i);
               return double(tracer.incoming(at, random, counts).g);
             }).mean;
    };
    const glm::ivec3 below = glm::ivec3(4, 0, 4) - scene.scene.origin;
    TraceSurface surface = test::surfaceOn(below, FaceDirection::Up, {.2f, .2f});
    EXPECT_GT(lightAt(surface), 0) << block;
    int own = 0;
    for (std::uint32_t i = 0; i < scene.scene.grid.quads().size(); ++i) {
      const TraceQuad& quad = scene.scene.grid.quad(i);
      if (quad.emission == 0) continue;
      surface.position = quad.corner + .1f * quad.edgeU + .1f * quad.edgeV;
      surface.normal = quad.normal;
      surface.quad = i;
      EXPECT_EQ(lightAt(surface), 0) << block;
      ++own;
    }
    EXPECT_GT(own, 4) << block;
  }
}

// The surface of lava is two quads in one place, and lights upward all the same.
TEST(LavaFloor, lights_the_ceiling_as_a_rectangle_does) {
  const BlockScene scene = test::blockScene(
      R"({"size": [9, 6, 9], "blocks": [
      {"hollow": "black_concrete", "min": [0, 0, 0], "max": [8, 5, 8]},
      {"box": "lava", "min": [1, 1, 1], "max": [7, 1, 7]}],
      "cameras": [{"name": "a", "position": [2, 3, 2], "yaw": 0, "pitch": 0, "fov": 60}]})",
      {{"minecraft:lava", kListedLamp}}, strengthOne());
  TraceSettings settings;
  settings.bounces = 1;
  const PathTracer tracer(scene.scene, {}, settings);
  RayCounts counts;
  const Estimate result = test::estimate(40000, [&](std::uint32_t i) {
    SampleRandom random(9, 1, i);
    const TraceSurface at = test::surfaceOn(glm::ivec3(4, 5, 4) - scene.scene.origin,
                                            FaceDirection::Down, {0.5f, 0.5f});
    return double(tracer.incoming(at, random, counts).g);
  });
  const double height = 5 - 1 - 8.0 / 9, half = 3.5 / height;
  const double expected = kWhiteGreen * 4 * cornerShare(half, half);
  EXPECT_NEAR(result.mean, expected, 0.002 * expected + 4 * result.error);
  EXPECT_LT(result.error, 0.005 * expected);
}

/// Lamps grey, all else white and without colour.
void greyLamps(BlockAtlas& atlas) {
  for (const auto& [name, tile] : atlas.tiles) {
    const int x0 = int(tile.min.x * float(atlas.albedo.width) + 0.5f);
    const int y0 = int(tile.min.y * float(atlas.albedo.height) + 0.5f);
    const bool lamp = name == "sea_lantern" || name == "lava_still";
    for (int y = y0; y < y0 + 16; ++y)
      for (int x = x0; x < x0 + 16; ++x)
        for (int c = 0; c < 3; ++c) atlas.albedo.at(x, y)[c] = std::uint8_t(lamp ? kGreyByte : 255);
  }
}

// Lava over its floor, and what is white in it, leave a closed box the light E / (1 - rho).
TEST(ClosedBoxOfBlocks, holds_e_over_one_less_rho_with_lava_water_and_glass_in_it) {
  const BlockScene scene = test::blockScene(
      R"({"size": [9, 7, 9], "blocks": [
      {"hollow": "sea_lantern", "min": [0, 0, 0], "max": [8, 6, 8]},
      {"box": "lava", "min": [1, 1, 1], "max": [7, 1, 7]},
      {"block": "glass", "at": [3, 3, 3]}, {"block": "white_stained_glass", "at": [5, 3, 4]},
      {"box": "water", "min": [3, 2, 5], "max": [4, 3, 6]}, {"block": "stone", "at": [6, 2, 6]},
      {"block": "glass_pane[north=true,south=true]", "at": [6, 3, 2]}],
      "cameras": [{"name": "a", "position": [2, 3, 2], "yaw": 0, "pitch": 0, "fov": 60}]})",
      {{"minecraft:sea_lantern", kListedLamp},
       {"minecraft:lava", kListedLamp},
       {"minecraft:water", 20},
       {"minecraft:white_stained_glass", 21}},
      strengthOne(), greyLamps);
  const PathTracer tracer(scene.scene, {}, {});
  RayCounts counts;
  const double rho = std::pow(kGreyByte / 255.0, 2.2), expected = kWhiteGreen / (1 - rho);
  const Estimate result = test::estimate(60000, [&](std::uint32_t i) {
    SampleRandom random(2, 0, i);
    const glm::vec2 at = random.pair() * 7.0f;
    const TraceSurface ceiling =
        test::surfaceOn(glm::ivec3(1 + int(at.x), 6, 1 + int(at.y)) - scene.scene.origin,
                        FaceDirection::Down, glm::fract(at));
    return double(tracer.incoming(ceiling, random, counts).g);
  });
  EXPECT_NEAR(result.mean, expected, 4 * result.error + 0.002 * expected);
  EXPECT_LT(result.error, 0.005 * expected);
}

}  // namespace
}  // namespace orris
