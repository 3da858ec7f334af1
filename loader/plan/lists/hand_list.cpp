// Hands of the player with what they hold, in view space.
#include <glm/gtc/matrix_transform.hpp>

#include <orris/plan/lists/list_writer.h>

namespace orris {
namespace {

const glm::vec3 kXAxis(1, 0, 0), kYAxis(0, 1, 0), kZAxis(0, 0, 1);

/// A cube 0..1 in the right hand, or in the left one.
glm::mat4 heldMatrix(const ContentScene& content, const std::string& item, bool left) {
  constexpr float kSize = 0.4f;
  const float side = left ? -1.0f : 1.0f;
  // The game's place of a hand.
  if (const ItemLook* look = content.lookOf(item))
    return glm::translate(glm::mat4(1), {0.56f * side, -0.52f, -0.72f}) *
           look->posed(left ? DisplayPlace::FirstLeft : DisplayPlace::FirstRight);
  const bool sprite = content.items.at(item).boxes.empty();
  glm::mat4 m = glm::translate(glm::mat4(1), {0.62f * side, -0.5f, -0.95f});
  m = glm::rotate(m, glm::radians(sprite ? -70.0f * side : 45.0f * side), kYAxis);
  m = glm::scale(m, glm::vec3(sprite ? 0.6f : kSize));
  return glm::translate(m, glm::vec3(-0.5f));
}

/// The bare arm: a long box whose end is the hand.
void addArm(ListWriter& writer, bool left, glm::ivec2 light) {
  const float side = left ? -1.0f : 1.0f;
  glm::mat4 m = glm::translate(glm::mat4(1), {0.5f * side, -0.62f, -0.7f});
  m = glm::rotate(m, glm::radians(18.0f * side), kYAxis);
  m = glm::rotate(m, glm::radians(-62.0f), kXAxis);
  m = glm::rotate(m, glm::radians(12.0f * side), kZAxis);
  // The texture runs from the shoulder, where the sleeve is, to the hand.
  const glm::vec3 half(0.125f, 0.375f, 0.125f);
  const glm::vec3 rights[] = {kXAxis, -kXAxis, kZAxis, -kZAxis};
  const AtlasTile tile = writer.scene.content.atlas.tile("figure_sleeve");
  ContentQuad quad;
  quad.light = light;
  quad.uv = tileUv(tile, {0, 0}, {0.25f, 0.75f});
  const auto add = [&](const glm::vec3& right, const glm::vec3& up, const glm::vec3& out) {
    const glm::vec3 corners[] = {out + up - right, out - up - right, out - up + right,
                                 out + up + right};
    for (std::size_t i = 0; i < 4; ++i)
      quad.corners[i] = glm::vec3(m * glm::vec4(corners[i] * half, 1));
    writer.quad(quad);
  };
  // The arm's upper end is the hand: what the texture has at its bottom.
  for (const glm::vec3& right : rights) add(right, -kYAxis, glm::cross(right, -kYAxis));
  quad.uv = tileUv(tile, {0, 0.75f}, {0.25f, 1});
  add(kXAxis, -kZAxis, kYAxis);
}

void addHand(ListWriter& writer, const std::string& item, bool left) {
  if (item.empty() || writer.state.environment.player.hideGui) return;
  const glm::ivec2 light = writer.lightAt(writer.state.cameraPosition);
  const BlockFacts& facts = writer.scene.content.items.at(item);
  ContentDraw draw;
  draw.geometry =
      isTranslucentItem(writer.scene, item) ? Geometry::HandTranslucent : Geometry::Hand;
  if (!facts.air) draw.item = item;
  writer.begin(draw);
  if (facts.air) return addArm(writer, left, light);
  const glm::mat4 place = heldMatrix(writer.scene.content, item, left);
  addItem(writer, item, place, light);
  if (!writer.state.environment.player.handGlint || draw.geometry != Geometry::Hand) return;
  draw.geometry = Geometry::HandGlint;
  writer.begin(draw);
  addItem(writer, item, place, light);
}

}  // namespace

void addHands(ListWriter& writer) {
  const Player& player = writer.scene.world.environment.player;
  addHand(writer, player.mainHand, false);
  addHand(writer, player.offHand, true);
}

}  // namespace orris
