// Which sections of the terrain are drawn.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include <orris/world/world.h>
#include "render/render_fixture.h"

namespace orris {
namespace {

/// Gold that is drawn fills the picture with red, wherever it is.
class DrawTerrainGL : public RenderTest {
 protected:
  void SetUp() override {
    RenderTest::SetUp();
    files_["/block.properties"] = "block.7=gold_block\n";
    files_["/gbuffers_terrain.vsh"] =
        "#version 330 compatibility\nin vec4 mc_Entity;\nflat out float gold;\n"
        "void main() { gold = mc_Entity.x == 7.0 ? 1.0 : 0.0; gl_Position = ftransform();\n"
        "  if (gold > 0.0) gl_Position = vec4(gl_VertexID % 4 < 2 ? -1.0 : 1.0, gl_VertexID % 4 % 3 == 0 ? 1.0 : -1.0, -1.0, 1.0); }\n";
    files_["/gbuffers_terrain.fsh"] =
        "#version 330 compatibility\nflat in float gold;\n"
        "void main() { gl_FragData[0] = vec4(gold, 1.0 - gold, 0.0, 1.0); }\n";
    files_["/final.vsh"] = "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n";
    files_["/final.fsh"] =
        "#version 330 compatibility\nuniform sampler2D colortex0;\n"
        "void main() { gl_FragData[0] = texelFetch(colortex0, ivec2(gl_FragCoord.xy), 0); }\n";
    files_["/shaders.properties"] = "sky=false\nstars=false\nsun=false\nmoon=false\n";
  }

  /// A section of air over three of rock, with gold in a cave in the lowest. Camera 0 is above, 1 in the cave, 2 in the rock.
  static World goldMine() {
    World world;
    world.blocks = BlockWorld({0, 0, 0}, {16, 64, 16});
    const auto fill = [&](glm::ivec3 low, glm::ivec3 high, const char* block) {
      world.blocks.fill(low, high, world.blocks.paletteIndex(*parseBlockState(block)));
    };
    fill({0, 0, 0}, {15, 47, 15}, "minecraft:stone");
    fill({4, 4, 4}, {11, 11, 11}, "minecraft:air");
    fill({7, 4, 7}, {8, 4, 8}, "minecraft:gold_block");
    for (const double height : {56.0, 8.0, 40.0}) {
      Camera camera;
      camera.name = "down";
      camera.position = {8, height, 8};
      camera.pitch = 90;
      camera.fov = 60;
      world.cameras.push_back(camera);
    }
    return world;
  }

  /// Is gold drawn, seen by a camera of that world?
  bool drawsGold(World world, std::size_t camera) {
    std::swap(world.cameras[0], world.cameras[camera]);
    EXPECT_TRUE(start(world)) << messages();
    draw();
    return showsGold();
  }
  /// The fog's colour, where nothing is drawn, is no pure red.
  bool showsGold() { return pixel("colortex0", 5, 5) == std::vector<float>{1, 0, 0, 1}; }
};

TEST_F(DrawTerrainGL, a_closed_cave_is_drawn_for_an_eye_inside_only) {
  EXPECT_FALSE(drawsGold(goldMine(), 0));
  EXPECT_TRUE(drawsGold(goldMine(), 1));
}

TEST_F(DrawTerrainGL, an_eye_in_rock_sees_all) { EXPECT_TRUE(drawsGold(goldMine(), 2)); }

TEST_F(DrawTerrainGL, an_engine_that_looks_from_beside_its_camera_or_in_parallel_sees_all) {
  ASSERT_TRUE(start(goldMine())) << messages();
  ViewMatrices matrices;
  matrices.view = glm::rotate(glm::mat4(1), glm::radians(90.0f), glm::vec3(1, 0, 0));
  matrices.projection = glm::perspective(1.0f, 1.0f, 0.05f, 256.0f);
  const auto drawsGoldWith = [&](const ViewMatrices& given) {
    session_->setMatrices(given);
    draw();
    return showsGold();
  };
  EXPECT_FALSE(drawsGoldWith(matrices));
  ViewMatrices beside = matrices;
  beside.view[3] = glm::vec4(0, 0, -2, 1);
  EXPECT_TRUE(drawsGoldWith(beside));
  ViewMatrices parallel = matrices;
  parallel.projection = glm::ortho(-10.0f, 10.0f, -10.0f, 10.0f, 0.05f, 256.0f);
  EXPECT_TRUE(drawsGoldWith(parallel));
}

TEST_F(DrawTerrainGL, a_shaft_dug_later_opens_the_cave) {
  World world = goldMine();
  for (int y = 12; y < 48; ++y) {
    Event event;
    event.frame = 1;
    event.action = SetBlock{{8, y, 8}, *parseBlockState("minecraft:air")};
    world.events.push_back(event);
  }
  ASSERT_TRUE(start(world)) << messages();
  draw(1);
  EXPECT_FALSE(showsGold());
  draw(2);
  EXPECT_TRUE(showsGold());
}

}  // namespace
}  // namespace orris
