// How blocks and block entities are drawn, and what of them reaches the shaders.
#include <gmock/gmock.h>

#include <orris/render/frame_renderer.h>
#include "render/render_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;

class DrawBlocksGL : public RenderTest {};

TEST_F(DrawBlocksGL, block_ids_and_vertex_attributes_reach_the_shader) {
  files_["/block.properties"] = "block.1234=minecraft:stone\n";
  files_["/gbuffers_terrain.vsh"] = R"(#version 330 compatibility
in vec4 mc_Entity;
in vec3 at_midBlock;
out vec4 data;
void main() {
  gl_Position = ftransform();
  data = vec4(mc_Entity.x, gl_MultiTexCoord1.y, at_midBlock.y, gl_Normal.y);
}
)";
  files_["/gbuffers_terrain.fsh"] = R"(#version 330 compatibility
in vec4 data;
/* RENDERTARGETS: 3 */
/*
const int colortex3Format = RGBA32F;
*/
void main() { gl_FragData[0] = data; }
)";
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  draw();
  // Top faces: full sky light, half a block above the centre, which midBlock points back to.
  EXPECT_THAT(pixel("colortex3", 16, 16),
              ElementsAre(1234, FloatNear(240, 0.01f), FloatNear(-32, 0.01f), FloatNear(1, 0.01f)));
}

TEST_F(DrawBlocksGL, block_entities_have_their_program_and_their_id) {
  files_["/block.properties"] = "block.77=minecraft:chest\nblock.78=minecraft:oak_sign\n";
  World world = floorWorld();
  const auto place = [&](glm::ivec3 at, const char* state) {
    world.blocks.set(at, world.blocks.paletteIndex(*parseBlockState(state)));
  };
  place({0, 1, 0}, "minecraft:chest");
  place({-1, 1, 0}, "minecraft:red_bed");
  files_["/gbuffers_block.vsh"] =
      "#version 330 compatibility\nuniform int blockEntityId;\nuniform int renderStage;\n"
      "in vec2 mc_Entity;\nin vec4 at_midBlock;\nflat out vec4 data;\n"
      "void main() {\n  gl_Position = ftransform();\n"
      "  data = vec4(blockEntityId, mc_Entity.x, at_midBlock.y, renderStage);\n}\n";
  files_["/gbuffers_block.fsh"] =
      "#version 330 compatibility\nflat in vec4 data;\n/* RENDERTARGETS: 3 */\n"
      "/*\nconst int colortex3Format = RGBA32F;\n*/\nvoid main() { gl_FragData[0] = data; }\n";
  addProgram("final", kPass);
  ASSERT_TRUE(start(world, 33, 33)) << messages();
  draw();
  EXPECT_THAT(pixel("colortex3", 16, 16), ElementsAre(77, -1, 0, 12));
  EXPECT_THAT(pixel("colortex3", 32, 32), ElementsAre(0, 0, 0, 0));
  bool unlisted = false;
  for (int x = 0; x < 33; ++x) unlisted |= pixel("colortex3", x, 16)[0] == -1;
  EXPECT_TRUE(unlisted) << "the bed has no id";
}

TEST_F(DrawBlocksGL, block_entities_that_give_light_may_alone_cast_shadows) {
  addProgram("shadow", "void main() { gl_FragData[0] = vec4(1.0); }\n");
  addProgram("final", "uniform sampler2D shadowtex0;\nvoid main() { gl_FragData[0] = texture(shadowtex0, uv); }\n");
  const auto casts = [&](const std::string& properties, const char* block) {
    files_["/shaders.properties"] = "shadowTerrain=false\n" + properties;
    World world = floorWorld();
    world.blocks.set({0, 1, 0}, world.blocks.paletteIndex(*parseBlockState(block)));
    EXPECT_TRUE(start(world, 33, 33)) << messages();
    draw();
    const auto depth = session_->renderer().dump("shadowtex0");
    return *std::ranges::min_element(depth->pixels) < 1;
  };
  const std::string none = "shadowBlockEntities=false\n", light = none + "shadowLightBlockEntities=true\n";
  EXPECT_FALSE(casts(none, "minecraft:ender_chest"));
  EXPECT_TRUE(casts(light, "minecraft:ender_chest"));
  EXPECT_FALSE(casts(light, "minecraft:chest"));
  EXPECT_TRUE(casts("", "minecraft:chest"));
}

TEST_F(DrawBlocksGL, translucent_quads_blend_from_far_to_near) {
  files_["/block.properties"] =
      "block.1=minecraft:red_stained_glass\nblock.2=minecraft:blue_stained_glass\n";
  files_["/shaders.properties"] = "sky=false\nstars=false\nsun=false\nmoon=false\n";
  files_["/gbuffers_water.vsh"] =
      "#version 330 compatibility\nin vec4 mc_Entity;\nflat out int id;\n"
      "void main() { gl_Position = ftransform(); id = int(mc_Entity.x); }\n";
  files_["/gbuffers_water.fsh"] =
      "#version 330 compatibility\nflat in int id;\n/* RENDERTARGETS: 0 */\n"
      "void main() { gl_FragData[0] = vec4(id == 1, 0.0, id == 2, 0.75); }\n";
  addProgram("final", kPass);
  for (const bool fromSouth : {true, false}) {
    World world;
    world.blocks = BlockWorld({0, 0, 0}, {16, 16, 16});
    const auto place = [&](int z, const char* state) {
      world.blocks.set({8, 8, z}, world.blocks.paletteIndex(*parseBlockState(state)));
    };
    place(6, "minecraft:red_stained_glass");
    place(9, "minecraft:blue_stained_glass");
    Camera camera;
    camera.position = {8.5, 8.5, fromSouth ? 14.0 : 1.0};
    camera.yaw = fromSouth ? 180 : 0;
    world.cameras = {camera};
    world.environment.fogColor = glm::vec3(0);
    ASSERT_TRUE(start(world)) << messages();
    draw();
    const auto color = pixel("colortex0", 16, 16);
    // The nearer pane covers three quarters of the farther one, which is drawn before it.
    EXPECT_NEAR(color[fromSouth ? 2 : 0], 0.75, 0.01);
    EXPECT_NEAR(color[fromSouth ? 0 : 2], 0.75 * 0.25, 0.01);
  }
}

TEST_F(DrawBlocksGL, alpha_test_discards_the_holes_of_cutout_blocks) {
  World world = floorWorld();
  world.blocks.fill({-1, 1, -1}, {1, 1, 1},
                    world.blocks.paletteIndex(*parseBlockState("minecraft:oak_leaves")));
  addProgram("gbuffers_terrain",
             "uniform sampler2D gtexture;\n/* RENDERTARGETS: 0 */\n"
             "void main() { gl_FragData[0] = vec4(1.0, 0.0, 0.0, texture2D(gtexture, uv).a); }\n");
  addProgram("final", kPass);
  ASSERT_TRUE(start(world, 64, 64)) << messages();
  draw();
  const auto image = session_->renderer().dump("depthtex0");
  float nearest = 1, farthest = 0;
  for (int y = 28; y < 36; ++y)
    for (int x = 28; x < 36; ++x) {
      nearest = std::min(nearest, image->at(x, y)[0]);
      farthest = std::max(farthest, image->at(x, y)[0]);
    }
  EXPECT_LT(nearest, farthest);  // some pixels see the floor through the leaves
}

TEST_F(DrawBlocksGL, shadow_map_holds_the_casters_and_its_copy_the_opaque_ones) {
  World world = floorWorld();
  world.blocks.set({0, 3, 0},
                   world.blocks.paletteIndex(*parseBlockState("minecraft:red_stained_glass")));
  addProgram("shadow",
             "const int shadowMapResolution = 64;\nconst float shadowDistance = 16.0;\n"
             "void main() { gl_FragData[0] = vec4(1.0); }\n");
  addProgram(
      "final",
      "uniform sampler2D shadowtex0;\nuniform sampler2D shadowtex1;\n"
      "void main() { gl_FragColor = texture2D(shadowtex0, uv) - texture2D(shadowtex1, uv); }\n");
  ASSERT_TRUE(start(world)) << messages();
  draw();
  const auto all = session_->renderer().dump("shadowtex0"),
             opaque = session_->renderer().dump("shadowtex1");
  ASSERT_EQ(all->width, 64);
  int nearer = 0, floor = 0;
  for (size_t i = 0; i < all->pixels.size(); ++i) {
    nearer += all->pixels[i] < opaque->pixels[i];
    floor += opaque->pixels[i] < 1;
  }
  EXPECT_EQ(floor, 32 * 32);  // 16 blocks of 32 across
  EXPECT_GE(nearer, 4);
  EXPECT_LE(nearer, 9);
}

}  // namespace
}  // namespace orris
