// Edits, options and blocks that change while a session draws.
#include <gmock/gmock.h>

#include "render/render_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class SessionChangeGL : public RenderTest {};

TEST_F(SessionChangeGL, errors_name_the_line_and_the_last_good_pack_keeps_running) {
  addProgram("composite",
             "/* RENDERTARGETS: 0 */\nvoid main() { gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0); }\n");
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  draw();
  files_["/composite.fsh"] =
      "#version 330 compatibility\nin vec2 uv;\n\nvoid main() { gl_FragColor = vec4(missing); }\n";
  EXPECT_FALSE(session_->reload("edit", diagnostics_));
  EXPECT_THAT(messages(), HasSubstr("/composite.fsh:4:"));
  EXPECT_THAT(messages(), HasSubstr("missing"));
  draw();
  EXPECT_THAT(pixel("colortex0", 4, 4), ElementsAre(0, 1, 0, 1));
}

TEST_F(SessionChangeGL, a_reload_builds_only_the_programs_that_changed) {
  files_["/settings.glsl"] = "#define SHADE 1.0 // [0.0 0.5 1.0]\n";
  addProgram("composite",
             "#include \"/settings.glsl\"\n/* RENDERTARGETS: 0 */\n"
             "void main() { gl_FragColor = vec4(SHADE); }\n");
  addProgram("composite1", "/* RENDERTARGETS: 1 */\nvoid main() { gl_FragColor = vec4(0.3); }\n");
  addProgram("final", kPass);
  World world = floorWorld();
  world.events = {{2, SetOption{"SHADE", "0.5"}}};
  ASSERT_TRUE(start(world)) << messages();
  draw(3);
  ASSERT_EQ(session_->reloads().size(), 2u);
  EXPECT_EQ(session_->reloads()[1].cause, "SHADE=0.5");
  EXPECT_THAT(session_->reloads()[1].report.built, ElementsAre("composite"));
  EXPECT_NEAR(pixel("colortex0", 1, 1)[0], 0.5f, 0.01f);
}

TEST_F(SessionChangeGL, a_reload_keeps_what_targets_hold_that_it_does_not_change) {
  files_["/settings.glsl"] = "#define WIDE 0 // [0 1]\n";
  const std::string clear = "const bool colortex4Clear = false;\n";
  addProgram("composite", clear +
                              "/* RENDERTARGETS: 4 */\nuniform sampler2D colortex4;\n"
                              "void main() { gl_FragColor = texture(colortex4, uv) + 0.125; }\n");
  addProgram("composite1",
             "#include \"/settings.glsl\"\n#if WIDE\n/*\nconst int colortex1Format = RGBA32F;\n*/\n"
             "#endif\n/* RENDERTARGETS: 1 */\nvoid main() { gl_FragColor = vec4(1.0 + WIDE); }\n");
  addProgram("final", kPass);
  World world = floorWorld();
  world.events = {{3, SetOption{"WIDE", "1"}}};
  ASSERT_TRUE(start(world)) << messages();
  draw(5);
  ASSERT_EQ(session_->reloads().size(), 2u) << messages();
  EXPECT_NEAR(pixel("colortex1", 1, 1)[0], 2.0f, 0.01f) << "a new format holds more than 1";
  EXPECT_NEAR(pixel("colortex4", 1, 1)[0], 5 * 0.125f, 0.01f);
}

TEST_F(SessionChangeGL, block_events_change_the_mesh_and_the_passes) {
  addProgram("final", kPass);
  World world = floorWorld();
  world.events = {{1, SetBlock{{0, 2, 0}, *parseBlockState("minecraft:red_stained_glass")}}};
  ASSERT_TRUE(start(world)) << messages();
  draw();
  const float floor = pixel("depthtex0", 16, 16)[0];
  draw();
  EXPECT_LT(pixel("depthtex0", 16, 16)[0], floor);
}

TEST_F(SessionChangeGL, fifty_edits_leave_no_gl_error_and_reuse_the_targets) {
  addProgram("final", kPass);
  ASSERT_TRUE(start(floorWorld())) << messages();
  for (int i = 0; i < 50; ++i) {
    addProgram("composite", "/* RENDERTARGETS: 0 */\nvoid main() { gl_FragColor = vec4(" +
                                std::to_string(i) + ".0 / 50.0); }\n");
    ASSERT_TRUE(session_->reload("edit", diagnostics_)) << messages();
    draw();
    EXPECT_NEAR(pixel("colortex0", 1, 1)[0], static_cast<float>(i) / 50, 0.01f);
  }
}

}  // namespace
}  // namespace orris
