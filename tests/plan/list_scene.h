// Worlds with things besides blocks, for tests of what is drawn of these.
#pragma once

#include <gmock/gmock.h>

#include <orris/core/files/file_source.h>
#include <orris/image/encode_png.h>
#include <orris/plan/lists/draw_lists.h>
#include <orris/world/files/world_json.h>

namespace orris {

/// A floor of 8 x 8 stones with these members of world.json.
inline World worldOf(const std::string& members) {
  Diagnostics diagnostics;
  auto world = parseWorldJson({"{\"size\": [8, 8, 8], \"blocks\": [{\"box\": \"stone\", \"min\": "
                               "[0, 0, 0], \"max\": [7, 0, 7]}]" +
                                   (members.empty() ? "" : ", " + members) + "}",
                               "world.json", "test", 0, nullptr},
                              diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << formatDiagnostic(d);
  return std::move(world).value();
}

/// The scene of that world.
inline SceneData sceneOf(const std::string& members) {
  Diagnostics diagnostics;
  SceneData scene = buildScene(worldOf(members), {}, diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << formatDiagnostic(d);
  return scene;
}

/// The first frame, looking north.
inline FrameState stateOf(const SceneData& scene, glm::dvec3 eye = {4, 3, 7}) {
  FrameInput input;
  input.width = 64;
  input.height = 48;
  input.environment = scene.world.environment;
  input.camera.position = eye;
  return nextFrameState(input, {}, nullptr);
}

/// In the middle of the floor.
inline Entity entityOf(const std::string& kind, const std::string& model) {
  Entity entity;
  entity.kind = kind;
  entity.model = model;
  entity.position = {4, 1, 4};
  return entity;
}

/// Of a floor with this entity alone.
inline DrawLists listsOf(const Entity& entity) {
  World world = worldOf("");
  world.content.entities = {entity};
  Diagnostics diagnostics;
  const SceneData scene = buildScene(std::move(world), {}, diagnostics);
  return buildDrawLists(scene, stateOf(scene));
}

/// The lowest and highest corner of what is drawn.
inline std::pair<glm::vec3, glm::vec3> boundsOf(const DrawLists& lists) {
  glm::vec3 low(1e9f), high(-1e9f);
  for (const GpuVertex& vertex : lists.vertices) {
    const glm::vec3 at(vertex.position[0], vertex.position[1], vertex.position[2]);
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  return {low, high};
}

/// A resource pack whose textures have another colour in each texel.
inline ResourceStack packOf(const std::vector<std::string>& textures, int width, int height) {
  std::map<std::string, std::string> files;
  Image16 image(width, height, 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 4; ++c)
        image.at(x, y)[c] = std::uint16_t((c == 0 ? x : c == 1 ? y : c == 2 ? 7 : 255) * 257);
  Diagnostics diagnostics;
  for (const std::string& name : textures)
    files["/minecraft/textures/" + name + ".png"] = encodePng(image, name, diagnostics).value();
  ResourceStack resources;
  resources.add("pack", memorySource(std::move(files)));
  return resources;
}

/// The texel of the skin in the middle of a quad; (-1, -1) where it wears none.
inline glm::ivec2 skinTexel(const SceneData& scene, const DrawLists& lists, unsigned quad) {
  const float* uv = lists.vertices[quad * 4].midUv;
  const Image8& atlas = scene.content.atlas.albedo;
  const std::uint8_t* texel = atlas.at(int(uv[0] * float(atlas.width)), int(uv[1] * float(atlas.height)));
  return texel[2] == 7 ? glm::ivec2(texel[0], texel[1]) : glm::ivec2(-1);
}

/// An iron sword of a full square of texels, whose model has these poses.
inline DrawLists posedLists(World world, const std::string& display) {
  Diagnostics diagnostics;
  std::map<std::string, std::string> files;
  files["/minecraft/textures/item/a.png"] = encodePng(Image16(1, 1, 3), "a", diagnostics).value();
  files["/minecraft/models/item/iron_sword.json"] =
      R"({"parent": "builtin/generated", "textures": {"layer0": "item/a"}, "display": {)" + display + "}}";
  ResourceStack resources;
  resources.add("pack", memorySource(std::move(files)));
  SceneData scene = buildScene(std::move(world), {}, diagnostics);
  scene.content = buildContent(scene.world, &resources, diagnostics);
  for (const Diagnostic& d : diagnostics) ADD_FAILURE() << formatDiagnostic(d);
  return buildDrawLists(scene, stateOf(scene));
}

inline void expectNear(const glm::vec3& value, const glm::vec3& expected) {
  EXPECT_LT(glm::length(value - expected), 1e-4f) << value.x << " " << value.y << " " << value.z;
}

}  // namespace orris
