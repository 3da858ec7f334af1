#include <gmock/gmock.h>

#include <orris/gl/functions.h>
#include <orris/render/frame_renderer.h>
#include "render/render_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;
using ::testing::HasSubstr;
using ::testing::Not;

class FrameRendererGL : public RenderTest {};

TEST_F(FrameRendererGL, colortex0_is_cleared_to_the_fog_colour) {
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
TEST_F(FrameRendererGL, the_sky_program_runs_in_every_direction) {
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

TEST_F(FrameRendererGL, programs_read_what_the_last_one_wrote) {
  // Each composite adds its own digit; a wrong side loses one.
  files_["/shaders.properties"] = "skipAllRendering=true\n";
  const std::string add = R"(
/* RENDERTARGETS: 4 */
/*
const int colortex4Format = R32F;
*/
uniform sampler2D colortex4;
void main() { gl_FragColor = vec4(texture2D(colortex4, uv).r * 10.0 + float(DIGIT)); }
)";
  const auto digit = [&](int d) { return "#define DIGIT " + std::to_string(d) + "\n" + add; };
  addProgram("composite", digit(1));
  addProgram("composite1", digit(2));
  addProgram("composite2", digit(3));
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  draw(3);
  EXPECT_THAT(pixel("colortex4", 3, 3), ElementsAre(123));
}

TEST_F(FrameRendererGL, renderers_with_one_pool_build_a_program_once) {
  pool_ = std::make_shared<ProgramPool>();
  files_["/shaders.properties"] = "skipAllRendering=true\nuniform.float.one = 1.0\n";
  addProgram("composite", "uniform float one;\nvoid main() { gl_FragColor = vec4(one); }\n");
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  EXPECT_EQ(session_->reloads().front().report.programsBuilt, 2);
  ASSERT_TRUE(start(floorWorld())) << messages();
  EXPECT_EQ(session_->reloads().front().report.programsBuilt, 0);
  draw();
  EXPECT_THAT(pixel("colortex0", 5, 5), ElementsAre(1, 1, 1, 1));
  // Another list of custom uniforms: `one` is in another place.
  files_["/shaders.properties"] =
      "skipAllRendering=true\nuniform.float.nought = 0.0\nuniform.float.one = 1.0\n";
  ASSERT_TRUE(start(floorWorld())) << messages();
  EXPECT_EQ(session_->reloads().front().report.programsBuilt, 2);
  draw();
  EXPECT_THAT(pixel("colortex0", 5, 5), ElementsAre(1, 1, 1, 1));
}

TEST_F(FrameRendererGL, every_renderer_of_a_pool_reports_what_its_driver_lacks) {
  if (!gl::isSoftwareRenderer(context_->driver().renderer)) GTEST_SKIP() << "this driver lacks nothing";
  pool_ = std::make_shared<ProgramPool>();
  files_["/shaders.properties"] = "skipAllRendering=true\n";
  files_["/composite.csh"] =
      "#version 430 compatibility\nlayout(local_size_x = 64) in;\n"
      "const ivec3 workGroups = ivec3(1, 1, 1);\nshared float much[12000];\n"
      "layout(rgba8) uniform image2D colorimg0;\n"
      "void main() { much[gl_LocalInvocationIndex] = 1.0; barrier();\n"
      "  imageStore(colorimg0, ivec2(0), vec4(much[63 - gl_LocalInvocationIndex])); }\n";
  addProgram("final", kPass);
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(start(floorWorld())) << messages();
    EXPECT_THAT(messages(), HasSubstr("rule shared-buffer"));
  }
}

TEST_F(FrameRendererGL, an_uncleared_buffer_counts_frames) {
  files_["/shaders.properties"] = "skipAllRendering=true\n";
  files_["/composite.vsh"] = kVertex;
  files_["/composite.fsh"] = R"(#version 330 compatibility
in vec2 uv;
/* RENDERTARGETS: 4 */
/*
const int colortex4Format = R32F;
*/
const bool colortex4Clear = false;
uniform sampler2D colortex4;
void main() { gl_FragColor = vec4(texture2D(colortex4, uv).r + 1.0); }
)";
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  draw(5);
  EXPECT_THAT(pixel("colortex4", 0, 0), ElementsAre(5));
}

TEST_F(FrameRendererGL, block_ids_and_vertex_attributes_reach_the_shader) {
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

TEST_F(FrameRendererGL, block_entities_have_their_program_and_their_id) {
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

TEST_F(FrameRendererGL, block_entities_that_give_light_may_alone_cast_shadows) {
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

TEST_F(FrameRendererGL, the_nether_and_the_end_are_never_wholly_dark) {
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

TEST_F(FrameRendererGL, the_end_has_a_sky_of_its_own_and_the_nether_none) {
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

TEST_F(FrameRendererGL, clouds_hang_above_and_move_west) {
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

TEST_F(FrameRendererGL, depth_copies_leave_out_translucent_blocks) {
  World world = floorWorld();
  world.blocks.set({0, 2, 0},
                   world.blocks.paletteIndex(*parseBlockState("minecraft:red_stained_glass")));
  addProgram(
      "final",
      "uniform sampler2D depthtex0;\nuniform sampler2D depthtex1;\n"
      "void main() { gl_FragColor = texture2D(depthtex0, uv) + texture2D(depthtex1, uv); }\n");
  ASSERT_TRUE(start(world)) << messages();
  draw();
  EXPECT_LT(pixel("depthtex0", 16, 16)[0], pixel("depthtex1", 16, 16)[0]);
  EXPECT_EQ(pixel("depthtex0", 2, 2)[0], pixel("depthtex1", 2, 2)[0]);
}

TEST_F(FrameRendererGL, buffer_without_an_output_stays_as_it_was) {
  files_["/shaders.properties"] = "blend.gbuffers_water = SRC_ALPHA ONE_MINUS_SRC_ALPHA ONE ONE\n";
  addProgram("gbuffers_terrain", "/* RENDERTARGETS: 0,1 */\n"
                                 "void main() { gl_FragData[0] = gl_FragData[1] = vec4(0.5); }\n");
  addProgram("gbuffers_water", "/* RENDERTARGETS: 0,1 */\n"
                               "void main() { gl_FragData[1] = vec4(1.0, 0.0, 0.0, 1.0); }\n");
  addProgram("composite", "/* RENDERTARGETS: 2,3 */\nlayout(location = 1) out vec4 color;\n"
                          "void main() { color = vec4(0.25); }\n");
  addProgram("final", "uniform sampler2D colortex0, colortex1, colortex2, colortex3;\n"
                      "layout(location = 0) out vec4 c;\nvoid main() { c = texture(colortex0, uv) + "
                      "texture(colortex1, uv) + texture(colortex2, uv) + texture(colortex3, uv); }\n");
  World world = floorWorld();
  const auto water = world.blocks.paletteIndex(*parseBlockState("minecraft:water"));
  world.blocks.fill({-4, 1, -4}, {4, 1, 4}, water);
  ASSERT_TRUE(start(world)) << messages();
  draw();
  EXPECT_THAT(pixel("colortex0", 16, 16), testing::Each(testing::FloatNear(0.5f, .01f)));
  EXPECT_NEAR(pixel("colortex1", 16, 16)[0], 1, .01);
  EXPECT_THAT(pixel("colortex2", 16, 16), testing::Each(0));
  EXPECT_NEAR(pixel("colortex3", 16, 16)[0], 0.25, .01);
}

TEST_F(FrameRendererGL, translucent_quads_blend_from_far_to_near) {
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

TEST_F(FrameRendererGL, alpha_test_discards_the_holes_of_cutout_blocks) {
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

TEST_F(FrameRendererGL, custom_uniforms_and_images_and_buffers_work_together) {
  files_["/shaders.properties"] = R"(skipAllRendering=true
iris.features.required=CUSTOM_IMAGES SSBO COMPUTE_SHADERS
uniform.float.doubled = viewWidth * 2.0
image.store = storeSampler RED R32F FLOAT false false 4 4
bufferObject.0 = 16
)";
  files_["/begin.csh"] = R"(#version 430 compatibility
layout(local_size_x = 4, local_size_y = 4) in;
const ivec3 workGroups = ivec3(1, 1, 1);
layout(r32f) uniform image2D store;
layout(std430, binding = 0) buffer Counter { uint count; };
uniform float doubled;
void main() {
  atomicAdd(count, 1u);
  imageStore(store, ivec2(gl_LocalInvocationID.xy), vec4(doubled));
}
)";
  addProgram("final", R"(
uniform sampler2D storeSampler;
layout(std430, binding = 0) buffer Counter { uint count; };
void main() { gl_FragColor = vec4(texelFetch(storeSampler, ivec2(1), 0).r, float(count), 0.0, 1.0); }
)");
  files_["/final.fsh"].replace(0, files_["/final.fsh"].find('\n'), "#version 430 compatibility");
  ASSERT_TRUE(start(floorWorld())) << messages();
  draw(2);
  EXPECT_THAT(pixel("store", 0, 0), ElementsAre(64));
}

TEST_F(FrameRendererGL, only_passes_that_store_and_those_after_them_wait) {
  files_["/shaders.properties"] = R"(skipAllRendering=true
iris.features.required=CUSTOM_IMAGES SSBO
image.store = storeSampler RED R32F FLOAT false false 4 4
bufferObject.0 = 16
)";
  for (const char* name : {"composite", "composite1", "composite3", "final"}) addProgram(name, kPass);
  addProgram("composite2",
             "layout(r32f) uniform image2D store;\nvoid main() {\n  imageStore(store, ivec2(0), vec4(1));\n"
             "  gl_FragData[0] = vec4(1);\n}\n");
  addProgram("composite4",
             "layout(std430, binding = 0) buffer Counter { uint count; };\nvoid main() {\n"
             "  atomicAdd(count, 1u);\n  gl_FragData[0] = vec4(1);\n}\n");
  for (const char* name : {"/composite2.fsh", "/composite4.fsh"})
    files_[name].replace(0, files_[name].find('\n'), "#version 430 compatibility");
  ASSERT_TRUE(start(floorWorld())) << messages();
  static int barriers;
  const auto original = std::exchange(gl::MemoryBarrier, [](GLbitfield) { ++barriers; });
  std::map<std::string, int> before;
  session_->renderer().watchSteps([&](const Step& step) { before[step.name] += std::exchange(barriers, 0); });
  barriers = 0;
  draw();
  gl::MemoryBarrier = original;
  for (const auto& [name, count] : before) {
    const bool waits = name == "composite2" || name == "composite3" || name == "composite4" || name == "final";
    EXPECT_EQ(count, waits ? 1 : 0) << name;
  }
}

TEST_F(FrameRendererGL, passes_over_the_screen_have_an_alpha_test_that_all_pass) {
  addProgram("composite", kPass);
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  int passes = 0;
  session_->renderer().watchSteps([&](const Step& step) {
    if (step.name != "composite" && step.name != "final") return;
    ++passes;
    int function = 0;
    gl::GetIntegerv(GL_ALPHA_TEST_FUNC, &function);
    EXPECT_TRUE(gl::IsEnabled(GL_ALPHA_TEST)) << step.name;
    EXPECT_EQ(function, GL_ALWAYS) << step.name;
  });
  draw();
  EXPECT_EQ(passes, 2);
}

TEST_F(FrameRendererGL, shadow_map_holds_the_casters_and_its_copy_the_opaque_ones) {
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

TEST_F(FrameRendererGL, an_extension_that_the_driver_lacks_is_a_limit_of_the_driver) {
  addProgram("composite",
             "#extension GL_NONE_such : enable\nvoid main() {\n  gl_FragColor = noSuch(uv);\n}\n");
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  EXPECT_THAT(messages(), testing::ContainsRegex("/composite.fsh:[23].*: warning: extension .*NONE_such.* "
                                        "(unsupported in fragment shader|not supported)"));
  EXPECT_THAT(messages(), HasSubstr("this driver cannot run the program; it is left out"));
  EXPECT_THAT(messages(), Not(HasSubstr("noSuch")));
}

TEST_F(FrameRendererGL, the_last_of_32_buffers_is_drawn_and_read) {
  addProgram("composite",
             "/*\nconst int colortex31Format = RGBA32F;\nconst int colortex16Format = RG16F;\n"
             "const bool colortex31Clear = false;\n"
             "const vec4 colortex16ClearColor = vec4(0.25, 0.5, 0.0, 1.0);\n*/\n"
             "/* RENDERTARGETS: 31 */\nuniform sampler2D colortex16, colortex31;\n"
             "void main() { gl_FragData[0] = texture2D(colortex31, uv) +\n"
             "    vec4(texture2D(colortex16, uv).rg, 1.0, 1.0); }\n");
  addProgram("final",
             "uniform sampler2D colortex31;\nvoid main() {\n"
             "  gl_FragData[0] = texture2D(colortex31, uv); }\n");
  ASSERT_TRUE(start(floorWorld())) << messages();
  // Flipped, kept from frame to frame, and none of the 29 others is made.
  draw(3);
  EXPECT_EQ(pixel("colortex31", 16, 16), (std::vector<float>{0.75f, 1.5f, 3, 3}));
  EXPECT_EQ(pixel("colortex16", 16, 16)[0], 0.25f);
  EXPECT_TRUE(pixel("colortex15", 16, 16).empty());
}

// What GL refuses fails the test at its end.
TEST_F(FrameRendererGL, scales_beyond_all_pictures_are_no_mistakes_of_gl) {
  addProgram("composite", "/* RENDERTARGETS: 0 */\nvoid main() { gl_FragColor = vec4(1.0); }\n");
  for (const std::string scale : {"1e30", "-2", "1 -1e30 1e30"}) {
    files_["/shaders.properties"] = "scale.composite=" + scale + "\n";
    ASSERT_TRUE(start(floorWorld())) << messages();
    draw();
    const bool covers = scale == "1e30";
    EXPECT_EQ(pixel("colortex0", 16, 16) == std::vector<float>(4, 1.0f), covers) << scale;
  }
}

}  // namespace
}  // namespace orris
