// What is in the air: particles, rain, snow, lightning.
#include <algorithm>
#include <cmath>

#include <orris/plan/lists/content_scene.h>
#include <orris/plan/lists/list_writer.h>
#include <orris/plan/scene/snow_sheet.h>

namespace orris {
namespace {

/// How a kind of particle looks and moves.
struct ParticleLook {
  const char* texture;
  Geometry geometry;
  float life, rise, size;  ///< seconds, blocks a second, blocks
  bool shines;
};
constexpr ParticleLook kLooks[] = {
    {"flame_particle", Geometry::Particles, 1.2f, 0.4f, 0.12f, true},
    {"smoke_particle", Geometry::Particles, 3.0f, 0.7f, 0.2f, false},
    {"spark_particle", Geometry::ParticlesTranslucent, 1.6f, 0.9f, 0.14f, true}};

/// 0..1, of a particle and a purpose.
float chance(int particle, int purpose) {
  const auto seed = static_cast<std::uint32_t>(particle * 8 + purpose);
  return static_cast<float>(mixBits(seed + 1) >> 8) / 16777216.0f;
}

/// A square that faces the screen.
ContentQuad facingQuad(const ListWriter& writer, const glm::vec3& at, float half) {
  const glm::mat4& toPlayer = writer.state.gbufferModelViewInverse;
  const glm::vec3 right = glm::vec3(toPlayer[0]) * half, up = glm::vec3(toPlayer[1]) * half;
  ContentQuad quad;
  quad.corners = {at - right + up, at - right - up, at + right - up, at + right + up};
  quad.hasNormal = false;
  return quad;
}

void addSource(ListWriter& writer, const ParticleSource& source, int first) {
  const ParticleLook& look = kLooks[static_cast<int>(source.kind)];
  ContentDraw draw;
  draw.geometry = look.geometry;
  writer.begin(draw);
  const AtlasTile tile = writer.scene.content.atlas.tile(look.texture);
  for (int i = 0; i < source.count; ++i) {
    const int id = first + i;
    const float lives = writer.state.frameTimeCounter / look.life + chance(id, 0);
    const float age = lives - std::floor(lives);
    const glm::dvec3 off((chance(id, 1) - 0.5) * 2, 0, (chance(id, 2) - 0.5) * 2);
    const glm::dvec3 place = source.position + off * double(source.spread) +
                             glm::dvec3(0, double(age * look.life * look.rise), 0);
    const float shrink = look.shines ? 1 - 0.6f * age : 0.5f + 0.5f * age;
    ContentQuad quad = facingQuad(writer, writer.local(place), look.size * shrink);
    quad.uv = tileUv(tile);
    if (!look.shines) quad.light = writer.lightAt(place);
    if (look.geometry == Geometry::ParticlesTranslucent) quad.color.a = 1 - age * 0.8f;
    writer.quad(quad);
  }
}

constexpr int kReach = 10;  // blocks, of the game's fancy graphics
constexpr float kSnowFall = 4.0f * 20 / 512 / kSnowSheetBlocks;  // sheets a second: four blocks in 512 ticks

/// The cells of a column that rain falls through: from and to, y; nothing where there is a roof.
std::optional<glm::ivec2> openPart(const ListWriter& writer, int x, int z) {
  constexpr int kOpenSky = 15;
  const int eye = static_cast<int>(std::floor(writer.state.cameraPosition.y));
  const auto open = [&](int y) { return writer.scene.light->sky({x, y, z}) == kOpenSky; };
  int low = eye + kReach;
  while (low > eye - kReach && open(low - 1)) --low;
  if (low == eye + kReach) return std::nullopt;
  return glm::ivec2(low, eye + kReach);
}

void addColumn(ListWriter& writer, int x, int z, bool snow) {
  const auto part = openPart(writer, x, z);
  const glm::vec3 foot = writer.local({x + 0.5, 0, z + 0.5});
  const float distance = std::sqrt(foot.x * foot.x + foot.z * foot.z);
  if (!part || distance > kReach || distance == 0) return;
  const float t = writer.state.frameTimeCounter, share = distance / kReach;
  const int id = static_cast<int>(mixBits(static_cast<std::uint32_t>(x * 7919 + z)) & 0xffff);
  const float fall = t * (snow ? kSnowFall : 2.6f) * (0.8f + 0.4f * chance(id, 3)) + chance(id, 4);
  const float v = -(fall - std::floor(fall)), drift = chance(id, 5);
  const glm::vec3 side = glm::vec3(-foot.z, 0, foot.x) / distance * 0.5f;
  const glm::vec3 low(foot.x, writer.local({0, part->x, 0}).y, foot.z);
  const glm::vec3 high(foot.x, writer.local({0, part->y, 0}).y, foot.z);
  const float across = snow ? 1 / kSnowSheetBlocks : 1.0f, perBlock = snow ? 1 / kSnowSheetBlocks : 0.5f;
  ContentQuad quad;
  quad.corners = {high - side, low - side, low + side, high + side};
  const float length = (high.y - low.y) * perBlock;
  quad.uv = {{{drift, v}, {drift, v + length}, {drift + across, v + length}, {drift + across, v}}};
  quad.color.a = ((1 - share * share) * (snow ? 0.3f : 0.5f) + 0.5f) * writer.state.environment.rain;
  quad.light = writer.lightAt({x + 0.5, double(part->y), z + 0.5});
  // The game's flakes are never dark.
  if (snow) quad.light = (quad.light * 3 + 240) / 4;
  quad.hasNormal = false;
  writer.quad(quad);
}

/// Shells of prisms that lean from joint to joint.
void addBolt(ListWriter& writer, const LightningBolt& bolt) {
  constexpr int kJoints = 8, kShells = 4;
  constexpr float kPart = 12, kWander = 5;
  ContentDraw draw;
  draw.geometry = Geometry::Lightning;
  draw.entity = "minecraft:lightning_bolt";
  writer.begin(draw);
  const auto joint = [&](int i) {
    const std::uint32_t bits = mixBits(static_cast<std::uint32_t>(i * 31 + 5));
    const float x = static_cast<float>(bits & 255) / 255 - 0.5f;
    const float z = static_cast<float>(bits >> 8 & 255) / 255 - 0.5f;
    const float off = i == 0 ? 0 : kWander;
    return writer.local(bolt.at) + glm::vec3(x * off, static_cast<float>(i) * kPart, z * off);
  };
  for (int i = 0; i < kJoints; ++i)
    for (int shell = 1; shell <= kShells; ++shell) {
      const float half = 0.1f * static_cast<float>(shell);
      const glm::vec2 ring[] = {{-half, half}, {half, half}, {half, -half}, {-half, -half}};
      for (int k = 0; k < 4; ++k) {
        const glm::vec3 a(ring[k].x, 0, ring[k].y), b(ring[(k + 1) % 4].x, 0, ring[(k + 1) % 4].y);
        ContentQuad quad;
        quad.corners = {joint(i + 1) + a, joint(i) + a, joint(i) + b, joint(i + 1) + b};
        quad.color = {0.45f, 0.45f, 0.5f, 0.3f};
        quad.hasNormal = false;
        writer.quad(quad);
      }
    }
}

}  // namespace

void addParticles(ListWriter& writer) {
  int first = 0;
  for (const ParticleSource& source : writer.scene.world.content.particles) {
    addSource(writer, source, first);
    first += source.count;
  }
}

void addLightning(ListWriter& writer) {
  for (const LightningBolt& bolt : writer.scene.world.content.bolts) addBolt(writer, bolt);
}

void addWeather(ListWriter& writer) {
  const GeometrySet weather = weatherOf(writer.scene.world.environment);
  if (weather == 0) return;
  const bool snow = (weather & bitOf(Geometry::Snow)) != 0;
  ContentDraw draw;
  draw.geometry = snow ? Geometry::Snow : Geometry::Rain;
  writer.begin(draw);
  const glm::ivec3 eye(glm::floor(writer.state.cameraPosition));
  for (int z = eye.z - kReach; z <= eye.z + kReach; ++z)
    for (int x = eye.x - kReach; x <= eye.x + kReach; ++x) addColumn(writer, x, z, snow);
}

}  // namespace orris
