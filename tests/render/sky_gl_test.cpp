// Sky, fog and clouds of each dimension.
#include <gmock/gmock.h>

#include <orris/render/frame_renderer.h>
#include "render/render_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;

class SkyGL : public RenderTest {};

TEST_F(SkyGL, colortex0_is_cleared_to_the_fog_colour) {
  addProgram("final", kPass);
  files_["/shaders.properties"] = "sky=false\nstars=false\nsun=false\nmoon=false\n";
  World world = floorWorld();
  world.blocks = BlockWorld({0, 0, 0}, {1, 1, 1});
  world.environment.fogColor = {0.25f, 0.5f, 0.75f};
  ASSERT_TRUE(start(world)) << messages();
  draw();
  EXPECT_THAT(pixel("colortex0", 5, 5), ElementsAre(FloatNear(0.25f, .01f), FloatNear(0.5f, .01f),
                                                    FloatNear(0.75f, .01f), 1));
}

// Iris: HorizonRenderer.
TEST_F(SkyGL, the_sky_program_runs_in_every_direction) {
  files_["/gbuffers_skybasic.vsh"] =
      "#version 330 compatibility\nout vec4 tint;\n"
      "void main() { gl_Position = ftransform(); tint = gl_Color; }\n";
  files_["/gbuffers_skybasic.fsh"] =
      "#version 330 compatibility\nin vec4 tint;\nuniform int renderStage;\n"
      "void main() { gl_FragData[0] = vec4(tint.rg, float(renderStage), 1.0); }\n";
  addProgram("final", kPass);
  files_["/shaders.properties"] = "stars=false\nsun=false\nmoon=false\n";
  World world = floorWorld();
  world.blocks = BlockWorld({0, 0, 0}, {1, 1, 1});
  world.environment.fogColor = {0.25f, 0.5f, 0.75f};
  world.environment.skyColor = {0.75f, 0.25f, 0.5f};
  const auto fog = ElementsAre(FloatNear(0.25f, .01f), FloatNear(0.5f, .01f), 1, 1);
  for (const float pitch : {90.0f, 45.0f, 0.0f}) {
    world.cameras[0].pitch = pitch;
    ASSERT_TRUE(start(world)) << messages();
    draw();
    EXPECT_THAT(pixel("colortex0", 5, 16), fog) << pitch;
  }
  world.cameras[0].pitch = -45;
  ASSERT_TRUE(start(world)) << messages();
  draw();
  EXPECT_THAT(pixel("colortex0", 5, 16),
              ElementsAre(FloatNear(0.75f, .01f), FloatNear(0.25f, .01f), 1, 1));
}

TEST_F(SkyGL, the_sky_has_a_fog_of_its_own) {
  const std::string range = "void main() { gl_FragData[0] = vec4(gl_Fog.start, gl_Fog.end, 0.0, 256.0) / 256.0; }\n";
  addProgram("gbuffers_skybasic", range);
  addProgram("composite", "/* RENDERTARGETS: 1 */\n" + range);
  addProgram("final", kPass);
  files_["/shaders.properties"] = "stars=false\nsun=false\nmoon=false\n";
  World world = floorWorld();
  world.blocks = BlockWorld({0, 0, 0}, {1, 1, 1});
  world.environment.renderDistance = 128;
  ASSERT_TRUE(start(world)) << messages();
  draw();
  EXPECT_THAT(pixel("colortex0", 5, 5), ElementsAre(0, FloatNear(0.5f, .01f), 0, 1));
  EXPECT_THAT(pixel("colortex1", 5, 5), ElementsAre(FloatNear(0.45f, .01f), FloatNear(0.5f, .01f), 0, 1));
}

TEST_F(SkyGL, the_nether_and_the_end_are_never_wholly_dark) {
  addProgram("gbuffers_terrain",
             "uniform sampler2D lightmap;\nvoid main() { gl_FragData[0] = texture(lightmap, vec2(0.5 / 16.0)); }\n");
  const auto darkest = [&](const char* dimension) {
    World world = floorWorld();
    world.environment.dimension = dimension;
    EXPECT_TRUE(start(std::move(world))) << messages();
    draw();
    return pixel("colortex0", 16, 16);
  };
  EXPECT_LT(darkest("minecraft:overworld")[0], 0.05f);
  EXPECT_NEAR(darkest("minecraft:the_nether")[0], 0.1f * (1.4f + 0.05f) * 0.96f + 0.03f, 0.01f);
  EXPECT_GT(darkest("minecraft:the_end")[1], 0.25f);
}

TEST_F(SkyGL, the_end_has_a_sky_of_its_own_and_the_nether_none) {
  addProgram("gbuffers_skytextured",
             "uniform sampler2D gtexture;\nuniform int renderStage;\n/* RENDERTARGETS: 3 */\n"
             "/*\nconst int colortex3Format = RGBA32F;\n*/\n"
             "void main() { gl_FragData[0] = vec4(texture(gtexture, uv).rg, float(renderStage), 1.0); }\n");
  addProgram("gbuffers_skybasic",
             "/* RENDERTARGETS: 4 */\n/*\nconst int colortex4Format = R8;\n*/\nvoid main() { gl_FragData[0] = vec4(1.0); }\n");
  addProgram("final", kPass);
  const auto drawnIn = [&](const char* dimension) {
    World world = floorWorld();
    world.environment.dimension = dimension;
    world.cameras[0].pitch = -90;
    EXPECT_TRUE(start(std::move(world), 33, 33)) << messages();
    draw();
  };
  // Of a program that is not drawn there is no buffer.
  const auto value = [&](const char* buffer, std::size_t channel) {
    const std::vector<float> values = pixel(buffer, 3, 30);
    return values.empty() ? 0 : values[channel];
  };
  drawnIn("minecraft:the_end");
  EXPECT_GT(value("colortex3", 0), value("colortex3", 1)) << "its purple";
  EXPECT_EQ(value("colortex3", 2), 1);
  EXPECT_EQ(value("colortex4", 0), 0);
  drawnIn("minecraft:the_nether");
  EXPECT_EQ(value("colortex3", 3), 0);
  EXPECT_EQ(value("colortex4", 0), 0);
  drawnIn("minecraft:overworld");
  EXPECT_EQ(value("colortex4", 0), 1);
}

TEST_F(SkyGL, clouds_hang_above_and_move_west) {
  addProgram("gbuffers_clouds",
             "/* RENDERTARGETS: 3 */\n/*\nconst int colortex3Format = R8;\n*/\n"
             "void main() { gl_FragData[0] = vec4(1.0); }\n");
  addProgram("final", kPass);
  World world = floorWorld();
  world.cameras[0].pitch = -90;
  world.environment.renderDistance = 512;
  const auto cover = [&](Clouds clouds, int frames) {
    world.environment.clouds = clouds;
    EXPECT_TRUE(start(world, 64, 64)) << messages();
    draw(frames);
    std::vector<float> row;
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) row.push_back(pixel("colortex3", x, y)[0]);
    return row;
  };
  const auto share = [](const std::vector<float>& row) {
    return static_cast<double>(std::count(row.begin(), row.end(), 1.0f)) / double(row.size());
  };
  const std::vector<float> fast = cover(Clouds::Fast, 1), fancy = cover(Clouds::Fancy, 1);
  EXPECT_GT(share(fast), 0.1);
  EXPECT_LT(share(fast), 0.7);
  // The sides of boxes cover more than flat cells.
  EXPECT_GT(share(fancy), share(fast));
  // Ten seconds later the pattern lies elsewhere.
  EXPECT_NE(cover(Clouds::Fast, 600), fast);
}

}  // namespace
}  // namespace orris
