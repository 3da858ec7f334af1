// What belongs to blocks or stands like them: texts, beams, cracks, outline, border.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include <orris/plan/lists/list_writer.h>
#include <orris/world/content/entity_models.h>
#include <orris/world/mesh/block_faces.h>

namespace orris {
namespace {

void addText(ListWriter& writer, const BlockText& text) {
  ContentDraw draw;
  draw.geometry = Geometry::BlockText;
  draw.block = writer.scene.world.blocks.at(text.at);
  writer.begin(draw);
  glm::mat4 place = glm::translate(glm::mat4(1), writer.local(text.position));
  place = glm::rotate(place, glm::radians(-text.yaw), glm::vec3(0, 1, 0));
  ContentQuad square;
  square.color = glm::vec4(text.color, 1);
  square.light = writer.lightAt(text.position);
  addGlyphs(writer, text.text, glm::scale(place, glm::vec3(text.size)), square);
}

/// The four sides of an upright prism, seen from outside.
void addPrism(ListWriter& writer, const glm::vec3& foot, float half, float height,
              const glm::vec4& color, float v) {
  const glm::vec2 ring[] = {{-half, half}, {half, half}, {half, -half}, {-half, -half}};
  for (int i = 0; i < 4; ++i) {
    const glm::vec3 a = foot + glm::vec3(ring[i].x, 0, ring[i].y);
    const glm::vec3 b = foot + glm::vec3(ring[(i + 1) % 4].x, 0, ring[(i + 1) % 4].y);
    const glm::vec3 up(0, height, 0);
    ContentQuad quad;
    quad.corners = {a + up, a, b, b + up};
    quad.uv = {{{0, v}, {0, v + height}, {1, v + height}, {1, v}}};
    quad.color = color;
    writer.quad(quad);
  }
}

void addBeams(ListWriter& writer) {
  constexpr float kHeight = 256, kCore = 0.2f, kGlow = 0.25f, kGlowAlpha = 0.125f;
  // The texture moves up; whole turns of it are left out, so that floats stay exact.
  const float scroll = writer.state.frameTimeCounter - std::floor(writer.state.frameTimeCounter);
  for (const Geometry geometry : {Geometry::BeamCore, Geometry::BeamGlow}) {
    for (const BeaconBeam& beam : writer.scene.world.content.beams) {
      ContentDraw draw;
      draw.geometry = geometry;
      draw.block = writer.scene.world.blocks.at(beam.at);
      writer.begin(draw);
      const bool core = geometry == Geometry::BeamCore;
      const glm::vec3 foot = writer.local(glm::dvec3(beam.at) + glm::dvec3(0.5, 1, 0.5));
      addPrism(writer, foot, core ? kCore : kGlow, kHeight,
               glm::vec4(beam.color, core ? 1 : kGlowAlpha), scroll);
    }
  }
}

// In front of the block's own faces by less than is seen.
constexpr float kCrackScale = 1.004f;

void addCracks(ListWriter& writer, const DamagedBlock& damage) {
  const std::uint32_t index = writer.scene.world.blocks.indexAt(damage.at);
  ContentDraw draw;
  draw.geometry = Geometry::Cracks;
  writer.begin(draw);
  const glm::vec3 origin = writer.local(glm::dvec3(damage.at));
  const AtlasTile tile = writer.scene.content.atlas.tile(crackTexture(damage.stage));
  for (const BlockFace& face :
       makeBlockFaces(writer.scene.facts[index], writer.scene.atlas).faces) {
    ContentQuad quad;
    for (std::size_t i = 0; i < 4; ++i)
      quad.corners[i] = origin + (face.corners[i] - 0.5f) * kCrackScale + 0.5f;
    quad.uv = tileUv(tile);
    writer.quad(quad);
  }
}

/// A line as wide on the screen everywhere, a little nearer than what it lies on. The game widens
/// its lines in the shader.
void addLine(ListWriter& writer, glm::vec3 from, glm::vec3 to) {
  constexpr float kNearer = 1 - 1.0f / 256;
  const float pixels = std::max(2.5f, static_cast<float>(writer.state.width) / 1920 * 2.5f);
  const float perBlock =
      pixels / (static_cast<float>(writer.state.height) * writer.state.gbufferProjection[1][1]);
  from *= kNearer;
  to *= kNearer;
  const glm::vec3 across = glm::cross(to - from, from);
  if (glm::length(across) == 0) return;
  const glm::vec3 side = glm::normalize(across) * perBlock;
  const glm::vec3 a = side * glm::length(from), b = side * glm::length(to);
  ContentQuad quad;
  quad.corners = {from + a, from - a, to - b, to + b};
  quad.color = {0, 0, 0, 0.4f};
  writer.quad(quad);
}

void addOutline(ListWriter& writer, const glm::ivec3& cell) {
  const BlockFacts& facts = writer.scene.facts[writer.scene.world.blocks.indexAt(cell)];
  glm::vec3 low(0), high(1);
  if (!facts.boxes.empty() && !facts.cross) {
    low = glm::vec3(1);
    high = glm::vec3(0);
    for (const ShapeBox& box : facts.boxes) {
      low = glm::min(low, box.from / 16.0f);
      high = glm::max(high, box.to / 16.0f);
    }
  }
  ContentDraw draw;
  draw.geometry = Geometry::Outline;
  writer.begin(draw);
  const glm::vec3 origin = writer.local(glm::dvec3(cell));
  const auto corner = [&](int bits) {
    return origin + glm::vec3((bits & 1) != 0 ? high.x : low.x, (bits & 2) != 0 ? high.y : low.y,
                              (bits & 4) != 0 ? high.z : low.z);
  };
  for (int bits = 0; bits < 8; ++bits)
    for (const int axis : {1, 2, 4})
      if ((bits & axis) == 0) addLine(writer, corner(bits), corner(bits | axis));
}

/// A wall of the border, as far as the eye is from it.
void addBorderWall(ListWriter& writer, const glm::dvec2& from, const glm::dvec2& to) {
  constexpr float kHeight = 64, kPerBlock = 0.5f;
  const float reach = static_cast<float>(writer.state.environment.renderDistance);
  const double eye = writer.state.cameraPosition.y;
  const glm::vec3 a = writer.local({from.x, eye, from.y}), b = writer.local({to.x, eye, to.y});
  const glm::vec3 nearest = glm::clamp(glm::vec3(0), glm::min(a, b), glm::max(a, b));
  const float alpha = std::pow(std::max(0.0f, 1 - glm::length(nearest) / reach), 4.0f);
  const float scroll = writer.state.frameTimeCounter / 3;
  const float v = scroll - std::floor(scroll), length = glm::length(b - a) * kPerBlock;
  ContentQuad quad;
  const glm::vec3 up(0, kHeight, 0);
  quad.corners = {a + up, a - up, b - up, b + up};
  quad.uv = {{{v, v},
              {v, v + 2 * kHeight * kPerBlock},
              {v + length, v + 2 * kHeight * kPerBlock},
              {v + length, v}}};
  quad.color = {0.125f, 0.627f, 1, alpha};
  quad.hasNormal = false;
  writer.quad(quad);
}

void addBorder(ListWriter& writer, const WorldBorder& border) {
  ContentDraw draw;
  draw.geometry = Geometry::Border;
  writer.begin(draw);
  const glm::dvec2 corners[] = {
      border.low, {border.high.x, border.low.y}, border.high, {border.low.x, border.high.y}};
  for (int i = 0; i < 4; ++i) addBorderWall(writer, corners[i], corners[(i + 1) % 4]);
}

}  // namespace

void addBlockOverlays(ListWriter& writer) {
  const WorldContent& content = writer.scene.world.content;
  for (const BlockText& text : content.texts) addText(writer, text);
  addBeams(writer);
  for (const DamagedBlock& damage : content.damaged) addCracks(writer, damage);
  if (content.selected) addOutline(writer, *content.selected);
  if (content.border) addBorder(writer, *content.border);
}

}  // namespace orris
