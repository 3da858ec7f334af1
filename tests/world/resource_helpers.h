// Resource packs made in a line, for the tests of this folder.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <memory>
#include <string>

#include <orris/image/encode_png.h>
#include <orris/world/resources/block_look.h>
#include "world_helpers.h"

namespace orris {

using Texel8 = std::array<int, 4>;

constexpr Texel8 kRed{200, 10, 10, 255}, kGreen{10, 200, 10, 255}, kBlue{10, 10, 200, 255};

/// A PNG whose texels `colour` gives.
inline std::string pngOf(int width, int height, const std::function<Texel8(int, int)>& colour) {
  Image16 image(width, height, 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (std::size_t c = 0; c < 4; ++c) image.at(x, y)[c] = std::uint16_t(colour(x, y)[c] * 257);
  Diagnostics diagnostics;
  return encodePng(image, "test.png", diagnostics).value();
}
inline std::string pngOf(int side, Texel8 colour) {
  return pngOf(side, side, [&](int, int) { return colour; });
}

/// Files below assets/minecraft; `look` draws a scene with them.
struct TestPack {
  std::map<std::string, std::string> files;
  std::string errors{};
  BlockAtlas atlas{};
  std::vector<BlockFacts> facts{};
  World world{};

  void state(const std::string& block, const std::string& json) {
    files["/minecraft/blockstates/" + block + ".json"] = json;
  }
  void model(const std::string& name, const std::string& json) {
    files["/minecraft/models/block/" + name + ".json"] = json;
  }
  void texture(const std::string& name, const std::string& bytes) {
    files["/minecraft/textures/" + name + ".png"] = bytes;
  }

  ResourceStack stack() const {
    ResourceStack resources;
    resources.add("pack", memorySource(files));
    return resources;
  }

  BlockLook look(const Scene& scene) {
    Diagnostics diagnostics;
    world.blocks = scene.blocks;
    facts = scene.facts();
    atlas = {};
    BlockLook made = makeBlockLook(stack(), world, facts, atlas, diagnostics);
    errors = joined(diagnostics);
    return made;
  }

  BlockMesh mesh(const Scene& scene) {
    const BlockLook made = look(scene);
    const LightLevels light(scene.blocks, facts);
    return buildMesh({scene.blocks, facts, light, atlas, 1, &made});
  }

  /// The first alternative of the first part of a state's model.
  std::vector<ModelFace> faces(const std::string& block) {
    Scene scene(glm::ivec3(1));
    scene.set({0, 0, 0}, block);
    const BlockLook made = look(scene);
    if (made.models[1].parts.empty()) return {};
    return *made.models[1].parts[0].alternatives[0].faces;
  }
};

/// The game's full cube, and one that wears a texture on all sides.
inline void addCubeModels(TestPack& pack) {
  std::string faces;
  for (const char* side : {"down", "up", "north", "south", "west", "east"})
    faces += fmt::format("{}\"{}\": {{\"texture\": \"#{}\", \"cullface\": \"{}\"}}",
                         faces.empty() ? "" : ", ", side, side, side);
  pack.model(
      "cube",
      fmt::format(R"({{"elements": [{{"from": [0,0,0], "to": [16,16,16], "faces": {{{}}}}}]}})",
                  faces));
  pack.model("cube_all",
             R"({"parent": "block/cube", "textures": {"particle": "#all", "down": "#all",
    "up": "#all", "north": "#all", "south": "#all", "west": "#all", "east": "#all"}})");
}

/// Cubes of stone with a red texture.
inline TestPack stonePack() {
  TestPack pack;
  addCubeModels(pack);
  pack.state("stone", R"({"variants": {"": {"model": "minecraft:block/stone"}}})");
  pack.model("stone",
             R"({"parent": "minecraft:block/cube_all", "textures": {"all": "block/stone"}})");
  pack.texture("block/stone", pngOf(16, kRed));
  return pack;
}

inline Scene oneBlock(const std::string& state) {
  Scene scene(glm::ivec3(1));
  scene.set({0, 0, 0}, state);
  return scene;
}

/// Of a picture of the atlas, `place` 0..1 within the tile.
inline Texel8 texelAt(const Image8& image, const BlockAtlas& atlas, const std::string& name,
                      glm::vec2 place) {
  const AtlasTile tile = atlas.tile(name);
  const glm::vec2 uv = tile.min + place * (tile.max - tile.min);
  const std::uint8_t* texel =
      image.at(int(uv.x * float(image.width)), int(uv.y * float(image.height)));
  return {texel[0], texel[1], texel[2], texel[3]};
}

}  // namespace orris
