#include <orris/plan/lists/list_writer.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace orris {
namespace {

std::int8_t contentSnorm(float v) {
  return static_cast<std::int8_t>(std::lround(std::clamp(v, -1.0f, 1.0f) * 127));
}

// A quad without area has neither.
glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& fallback) {
  const float length = glm::length(v);
  return length > 0 ? v / length : fallback;
}

}  // namespace

std::array<glm::vec2, 4> tileUv(const AtlasTile& tile, glm::vec2 low, glm::vec2 high) {
  const glm::vec2 size = tile.max - tile.min;
  const glm::vec2 a = tile.min + low * size, b = tile.min + high * size;
  return {{{a.x, a.y}, {a.x, b.y}, {b.x, b.y}, {b.x, a.y}}};
}

void ListWriter::begin(ContentDraw draw) {
  end();
  draw.range = {static_cast<unsigned>(lists_.vertices.size()), 0};
  lists_.draws.push_back(std::move(draw));
}

void ListWriter::end() {
  if (lists_.draws.empty()) return;
  QuadRange& range = lists_.draws.back().range;
  range.quads = static_cast<unsigned>(lists_.vertices.size() - range.firstVertex) / 4;
  if (range.quads == 0) lists_.draws.pop_back();
}

DrawLists ListWriter::take() {
  end();
  return std::move(lists_);
}

void ListWriter::quad(const ContentQuad& quad) {
  const glm::vec3 right = unitOr(quad.corners[3] - quad.corners[0], {1, 0, 0});
  const glm::vec3 down = unitOr(quad.corners[1] - quad.corners[0], {0, -1, 0});
  const glm::vec3 normal =
      quad.hasNormal ? unitOr(glm::cross(down, right), {0, 0, 1}) : glm::vec3(0, 0, 1);
  const glm::vec2 mid = (quad.uv[0] + quad.uv[2]) * 0.5f;
  for (std::size_t i = 0; i < 4; ++i) {
    GpuVertex& v = lists_.vertices.emplace_back();
    const glm::vec2 uv = quad.uv[i] + (mid - quad.uv[i]) * kUvInset;
    for (int k = 0; k < 3; ++k) {
      v.position[k] = quad.corners[i][k];
      v.normal[k] = contentSnorm(normal[k]);
      v.tangent[k] = contentSnorm(right[k]);
    }
    for (int k = 0; k < 2; ++k) {
      v.uv[k] = uv[k];
      v.midUv[k] = mid[k];
      v.light[k] = static_cast<std::int16_t>(quad.light[k]);
    }
    for (int k = 0; k < 4; ++k)
      v.color[k] =
          static_cast<std::uint8_t>(std::lround(std::clamp(quad.color[k], 0.0f, 1.0f) * 255));
  }
}

glm::vec3 ListWriter::local(const glm::dvec3& place) const {
  return glm::vec3(place - state.cameraPosition);
}

glm::ivec2 ListWriter::lightAt(const glm::dvec3& place) const {
  const glm::ivec3 cell(glm::floor(place));
  return {scene.light->block(cell) * 16, scene.light->sky(cell) * 16};
}

DrawLists buildDrawLists(const SceneData& scene, const FrameState& state) {
  if (scene.contents().content == 0) return {};
  ListWriter writer(scene, state);
  addEntities(writer);
  addLightning(writer);
  addBlockOverlays(writer);
  addParticles(writer);
  addWeather(writer);
  addHands(writer);
  return writer.take();
}

}  // namespace orris
