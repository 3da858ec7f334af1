// Items: models of a resource pack, blocks, and sprites for all others.
#include <glm/glm.hpp>
#include <utility>

#include <orris/plan/lists/list_writer.h>
#include <orris/world/mesh/block_faces.h>

namespace orris {
namespace {

// What the game's grass and leaves look like on the plains.
constexpr glm::vec3 kPlainsTint(0.57f, 0.74f, 0.35f);

void addSprite(ListWriter& writer, const glm::mat4& place, glm::ivec2 light) {
  const AtlasTile tile = writer.scene.content.atlas.tile("item_sprite");
  const glm::vec3 corners[] = {{0, 1, 0.5f}, {0, 0, 0.5f}, {1, 0, 0.5f}, {1, 1, 0.5f}};
  ContentQuad quad;
  quad.uv = tileUv(tile);
  quad.light = light;
  for (std::size_t i = 0; i < 4; ++i) quad.corners[i] = glm::vec3(place * glm::vec4(corners[i], 1));
  writer.quad(quad);
  std::swap(quad.corners[0], quad.corners[3]);
  std::swap(quad.corners[1], quad.corners[2]);
  std::swap(quad.uv[0], quad.uv[3]);
  std::swap(quad.uv[1], quad.uv[2]);
  writer.quad(quad);
}

/// An item by its model of a resource pack.
void addModel(ListWriter& writer, const ItemLook& look, const glm::mat4& place, glm::ivec2 light,
              const std::optional<glm::vec3>& dye) {
  for (const ModelFace& face : *look.faces) {
    const AtlasTile tile = writer.scene.content.atlas.tile(face.texture);
    ContentQuad quad;
    for (std::size_t i = 0; i < 4; ++i) {
      quad.corners[i] = glm::vec3(place * glm::vec4(face.corners[i], 1));
      quad.uv[i] = tile.min + face.uv[i] * (tile.max - tile.min);
    }
    quad.light = light;
    quad.color = glm::vec4(look.tintOf(face.tintIndex, dye), 1);
    writer.quad(quad);
  }
}

}  // namespace

bool isTranslucentItem(const SceneData& scene, const std::string& item) {
  return scene.content.items.at(item).layer == RenderLayer::Translucent;
}

void addItem(ListWriter& writer, const std::string& item, const glm::mat4& place,
             glm::ivec2 light, const std::optional<glm::vec3>& dye) {
  if (const ItemLook* look = writer.scene.content.lookOf(item))
    return addModel(writer, *look, place, light, dye);
  const BlockFacts& facts = writer.scene.content.items.at(item);
  if (facts.boxes.empty()) return addSprite(writer, place, light);
  for (const BlockFace& face : makeBlockFaces(facts, writer.scene.content.atlas).faces) {
    ContentQuad quad;
    for (std::size_t i = 0; i < 4; ++i)
      quad.corners[i] = glm::vec3(place * glm::vec4(face.corners[i], 1));
    quad.uv = face.uv;
    quad.light = light;
    if (face.tinted) quad.color = glm::vec4(kPlainsTint, 1);
    writer.quad(quad);
  }
}

}  // namespace orris
