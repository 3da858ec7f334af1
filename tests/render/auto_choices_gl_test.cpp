// Options that choose for themselves, in a session: by the scene, again when it has changed by much.
#include <gmock/gmock.h>

#include "plan/lamp_floor.h"
#include "render_fixture.h"

namespace orris {
namespace {

using testing::HasSubstr;

/// Shows which value of METHOD the program was compiled for: 0.25 ONE, 0.5 TWO, 1 AUTO.
class AutoSession : public RenderTest {
 protected:
  void addPack(const std::string& costs) {
    addProgram("final",
               "#define ONE 1\n#define TWO 2\n#define AUTO 4\n"
               "#define METHOD AUTO // [ONE TWO AUTO]\n"
               "layout(location = 0) out vec4 c;\n#if METHOD == AUTO\n#endif\n"
               "void main() { c = vec4(METHOD * 0.25); }\n");
    files_["/shaders.properties"] = "orris.features.optional = AUTO_OPTIONS\n" + costs;
  }
  float shown() { return float(session_->renderer().screenshot().pixels[0]) / 255; }
  std::string chosen() const { return session_->autoChoices().text(); }
};

constexpr const char* kByLamps = "auto.method.one = 1 + 1 lamps\nauto.method.two = 10\n";

World withLamps(int count, const char* event = nullptr) {
  World world = lampFloor(count);
  if (event)
    for (int i = 0; i < 30; ++i)
      world.events.push_back({3, SetBlock{{i % 8 - 4, 1, i / 8 - 4}, *parseBlockState(event)}});
  return world;
}

TEST_F(AutoSession, programs_are_those_of_the_value_that_costs_least) {
  addPack(kByLamps);
  ASSERT_TRUE(start(withLamps(2))) << messages();
  draw();
  EXPECT_EQ(chosen(), "METHOD=ONE");
  EXPECT_NEAR(shown(), 0.25, 0.01);
  EXPECT_EQ(session_->autoChoices().quantities().at("lamps"), 2);
  ASSERT_TRUE(start(withLamps(20))) << messages();
  draw();
  EXPECT_EQ(chosen(), "METHOD=TWO");
  EXPECT_NEAR(shown(), 0.5, 0.01);
}

TEST_F(AutoSession, programs_that_no_edit_reaches_are_taken_over_with_their_choice) {
  addPack(kByLamps);
  files_["/composite.vsh"] = files_["/final.vsh"];
  files_["/composite.fsh"] = files_["/final.fsh"];
  ASSERT_TRUE(start(withLamps(2))) << messages();
  draw();
  const auto program = [this](const char* name) { return session_->renderer().pack().find(name); };
  const auto running = session_->renderer().sharedPack();
  files_["/final.fsh"] += "// edited\n";
  session_->begin("edit", [this](LoadRequest& request, Diagnostics& diagnostics) {
    return std::make_shared<const ShaderPack>(*loadShaderPack(memorySource(files_), request, diagnostics));
  });
  EXPECT_EQ(session_->finish(diagnostics_), true) << messages();
  EXPECT_EQ(chosen(), "METHOD=ONE");
  EXPECT_EQ(program("composite"), running->find("composite"));
  EXPECT_NE(program("final"), running->find("final"));
}

TEST_F(AutoSession, value_that_was_asked_for_is_not_overruled) {
  addPack(kByLamps);
  ASSERT_TRUE(start(withLamps(20), 32, 32, {.values = {{"METHOD", "ONE"}}})) << messages();
  draw();
  EXPECT_EQ(chosen(), "");
  EXPECT_NEAR(shown(), 0.25, 0.01);
}

TEST_F(AutoSession, the_packs_own_choice_holds_where_none_is_allowed) {
  addPack("auto.method.one = 1 if lamps >= 100\n");
  ASSERT_TRUE(start(withLamps(2))) << messages();
  draw();
  EXPECT_EQ(chosen(), "METHOD=AUTO");
  EXPECT_NEAR(shown(), 1, 0.01);
}

TEST_F(AutoSession, choice_follows_the_lamps_after_a_while) {
  addPack(kByLamps);
  ASSERT_TRUE(start(withLamps(2, "minecraft:sea_lantern"))) << messages();
  draw(10);
  EXPECT_EQ(chosen(), "METHOD=ONE") << "not with every block";
  draw(20);
  EXPECT_EQ(chosen(), "METHOD=TWO");
  EXPECT_NEAR(shown(), 0.5, 0.01);
  ASSERT_EQ(session_->reloads().size(), 2u);
  EXPECT_THAT(session_->reloads()[1].cause, HasSubstr("METHOD=TWO"));
  draw(60);
  EXPECT_EQ(session_->reloads().size(), 2u);
}

TEST_F(AutoSession, choice_follows_other_options_and_edits_of_the_pack) {
  addPack(kByLamps);
  ASSERT_TRUE(start(withLamps(2))) << messages();
  files_["/shaders.properties"] =
      "orris.features.optional = AUTO_OPTIONS\nauto.method.two = 1\nauto.method.one = 2\n";
  ASSERT_TRUE(session_->reload("files changed", diagnostics_));
  EXPECT_EQ(chosen(), "METHOD=TWO");
  ASSERT_TRUE(session_->setOption("METHOD", "ONE", diagnostics_));
  EXPECT_EQ(chosen(), "");
  ASSERT_TRUE(session_->setOption("METHOD", "AUTO", diagnostics_));
  EXPECT_EQ(chosen(), "METHOD=TWO");
}

TEST_F(AutoSession, only_what_the_options_at_auto_ask_for_is_measured) {
  addPack("auto.method.one = 1 lamps\nauto.other.one = 1 volumes\n");
  files_["/final.fsh"] += "#define OTHER ONE // [ONE TWO AUTO]\n#if OTHER == AUTO\n#endif\n";
  ASSERT_TRUE(start(withLamps(2))) << messages();
  const Quantities& measured = session_->autoChoices().quantities();
  EXPECT_TRUE(measured.contains("lamps"));
  EXPECT_FALSE(measured.contains("volumes")) << "which takes long";
}

TEST_F(AutoSession, cost_that_another_choice_brings_is_measured_too) {
  addPack("#define ONE 1\n#define AUTO 4\nauto.method.one = 1\n#if METHOD == ONE\nauto.other.one = 1 lamps\nauto.other.two = 10\n#endif\n"
          "#if METHOD == AUTO\nauto.other.one = 20\nauto.other.two = 10\n#endif\n");
  files_["/final.fsh"] += "#define OTHER AUTO // [ONE TWO AUTO]\n#if OTHER == AUTO\n#endif\n";
  ASSERT_TRUE(start(withLamps(20))) << messages();
  EXPECT_EQ(chosen(), "METHOD=ONE OTHER=TWO");
  EXPECT_EQ(session_->autoChoices().quantities().at("lamps"), 20);
}

TEST_F(AutoSession, pack_that_does_not_compile_leaves_the_choice) {
  addPack(kByLamps);
  ASSERT_TRUE(start(withLamps(2))) << messages();
  const std::string good = files_["/final.fsh"];
  files_["/final.fsh"] = good + "#if METHOD == ONE\nbroken\n#endif\n";
  EXPECT_FALSE(session_->reload("files changed", diagnostics_));
  EXPECT_EQ(chosen(), "METHOD=ONE");
  draw();
  EXPECT_NEAR(shown(), 0.25, 0.01);
}

}  // namespace
}  // namespace orris
