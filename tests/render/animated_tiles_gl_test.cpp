// Textures of resource packs that move, as a frame shows them.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <orris/image/encode_png.h>
#include "render/render_fixture.h"

namespace orris {
namespace {

namespace fs = std::filesystem;
using ::testing::MatchesRegex;

/// A folder that holds a resource pack for stone, whose texture has a red and a green frame of a tick each.
class AnimatedTilesGL : public RenderTest {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() /
              ("orris-animated-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
               "-" + std::to_string(getpid()));
    Image16 strip(16, 32, 4);
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 16; ++x) {
        strip.at(x, y)[y < 16 ? 0 : 1] = 65535;
        strip.at(x, y)[3] = 65535;
      }
    Diagnostics diagnostics;
    const std::string bytes = encodePng(strip, "stone.png", diagnostics).value();
    for (const char* map : {"stone", "stone_n", "stone_s"})
      write("textures/block/" + std::string(map) + ".png", bytes);
    write("blockstates/stone.json", R"({"variants": {"": {"model": "block/stone"}}})");
    write("models/block/stone.json",
          R"({"parent": "block/cube_all", "textures": {"all": "block/stone"}})");
  }
  void TearDown() override {
    RenderTest::TearDown();
    fs::remove_all(folder_);
  }

  void write(const std::string& name, const std::string& bytes) const {
    const fs::path path = folder_ / "assets/minecraft" / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
  }

  /// The first letters of the colours of so many frames.
  std::string colours(const std::string& meta, int frames, const std::string& sampler = "gtexture") {
    write("textures/block/stone.png.mcmeta", meta);
    addProgram("gbuffers_terrain", "uniform sampler2D " + sampler +
                                       ";\nvoid main() { gl_FragData[0] = texture(" + sampler + ", uv); }\n");
    World world = floorWorld();
    world.resourcePacks = {folder_.string()};
    EXPECT_TRUE(start(std::move(world))) << messages();
    std::string text;
    for (int i = 0; i < frames; ++i) {
      draw();
      const std::vector<float> value = pixel("colortex0", 16, 16);
      text += value[0] > 0.9f ? 'r' : value[1] > 0.9f ? 'g' : 'm';
    }
    return text;
  }

  fs::path folder_;
};

TEST_F(AnimatedTilesGL, frames_follow_the_ticks) {
  // Three frames of a sixtieth of a second are a tick.
  EXPECT_THAT(colours(R"({"animation": {}})", 14),
              MatchesRegex("r{2,4}g{2,4}r{2,4}g{2,4}r{0,4}"));
}

TEST_F(AnimatedTilesGL, an_interpolated_one_is_mixed_in_between) {
  EXPECT_THAT(colours(R"({"animation": {"frametime": 2, "interpolate": true}})", 14),
              MatchesRegex("r{2,4}m{2,4}g{2,4}m{2,4}r{0,4}"));
}

TEST_F(AnimatedTilesGL, maps_beside_a_texture_move_with_it) {
  for (const char* sampler : {"normals", "specular"})
    EXPECT_THAT(colours(R"({"animation": {}})", 11, sampler), MatchesRegex("r{2,4}g{2,4}r{2,4}g{0,4}")) << sampler;
}

TEST_F(AnimatedTilesGL, items_in_the_hand_move_too) {
  write("textures/block/stone.png.mcmeta", R"({"animation": {}})");
  addProgram("gbuffers_hand",
             "uniform sampler2D gtexture;\nvoid main() { gl_FragData[0] = texture(gtexture, uv); }\n");
  World world = floorWorld();
  world.environment.player.mainHand = "minecraft:stone";
  world.environment.player.hideGui = false;
  world.cameras[0].position.y = 1.3;
  world.resourcePacks = {folder_.string()};
  ASSERT_TRUE(start(std::move(world))) << messages();
  std::string text;
  for (int i = 0; i < 11; ++i) {
    draw();
    const std::vector<float> value = pixel("colortex0", 27, 26);
    text += value[0] > 0.9f ? 'r' : value[1] > 0.9f ? 'g' : 'm';
  }
  EXPECT_THAT(text, MatchesRegex("r{2,4}g{2,4}r{2,4}g{0,4}"));
}

TEST_F(AnimatedTilesGL, one_without_meta_stands_still) {
  // Both frames are squeezed into the block.
  const std::string text = colours("{}", 8);
  EXPECT_EQ(text, std::string(8, text[0]));
}

}  // namespace
}  // namespace orris
