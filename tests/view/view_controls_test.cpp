#include "app/view/surface/view_controls.h"

#include <gmock/gmock.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/view/script/view_script.h"

#include <nlohmann/json.hpp>

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ViewEvent key(int code, bool pressed = true) {
  return {.kind = ViewEvent::Kind::Key, .code = code, .pressed = pressed};
}
ViewEvent move(double x, double y) { return {.kind = ViewEvent::Kind::Move, .x = x, .y = y}; }
ViewEvent press() { return {.kind = ViewEvent::Kind::Button, .pressed = true}; }

TEST(ViewControls, held_keys_fly_until_they_are_let_go) {
  ViewControls controls;
  EXPECT_EQ(controls.take({key(GLFW_KEY_W), key(GLFW_KEY_SPACE)}, {}).keys.forward, 1);
  const ViewInput next = controls.take({key(GLFW_KEY_SPACE, false)}, {.keys = true});
  EXPECT_EQ(next.keys.forward, 1);
  EXPECT_EQ(next.keys.up, 0);
}

TEST(ViewControls, each_press_is_one_command) {
  ViewControls controls;
  const ViewInput input = controls.take({key(GLFW_KEY_R), key(GLFW_KEY_K), key(GLFW_KEY_3)}, {});
  EXPECT_THAT(input.commands, ElementsAre(ViewCommand::Reload, ViewCommand::PackOnOff));
  EXPECT_EQ(input.camera, 2);
  EXPECT_THAT(controls.take({}, {}).commands, IsEmpty());
}

TEST(ViewControls, what_is_drawn_over_the_picture_takes_keys_and_mouse) {
  ViewControls controls;
  const ViewEvent wheel{.kind = ViewEvent::Kind::Scroll, .y = 1};
  const ViewInput input =
      controls.take({key(GLFW_KEY_R), press(), wheel}, {.keys = true, .mouse = true});
  EXPECT_THAT(input.commands, IsEmpty());
  EXPECT_FALSE(controls.holdsMouse());
  EXPECT_EQ(input.scroll, 0);
}

TEST(ViewControls, the_mouse_looks_while_it_is_held_and_escape_gives_it_back) {
  ViewControls controls;
  EXPECT_EQ(controls.take({move(10, 10), move(50, 10)}, {}).lookX, 0);
  const ViewInput input = controls.take({press(), move(53, 14)}, {});
  EXPECT_EQ(input.lookX, 3);
  EXPECT_EQ(input.lookY, 4);
  EXPECT_FALSE(controls.take({key(GLFW_KEY_ESCAPE)}, {}).close);
  EXPECT_FALSE(controls.holdsMouse());
  EXPECT_TRUE(controls.take({key(GLFW_KEY_ESCAPE)}, {}).close);
}

TEST(ViewKeys, every_command_has_one_key_that_scripts_can_name) {
  std::set<int> keys;
  for (const KeyRow& row : keyRows()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.name;
    EXPECT_EQ(keyNamed(row.name), row.key) << row.name;
  }
  EXPECT_EQ(keyNamed("escape"), GLFW_KEY_ESCAPE);
  EXPECT_FALSE(keyNamed("Hyper"));
}

std::string check(const char* wanted) {
  const nlohmann::json state = {{"a", {{"b", 2.5}}}, {"text", "red tint"}, {"list", {"x", "y"}}};
  Diagnostics diagnostics;
  const std::string text = std::string("[{\"expect\": ") + wanted + "}]";
  const auto script = parseViewScript("s.json", text, diagnostics);
  return script ? mismatch(state, script->steps.at(0).value) : "unreadable";
}

TEST(ViewScript, places_of_the_state_are_compared) {
  EXPECT_EQ(check(R"({"/a/b": 2.5, "/list/1": "y", "/list": ["x", "y"]})"), "");
  EXPECT_EQ(check(R"({"/a/b": {"min": 2, "max": 3}, "/text": {"contains": "tint"}})"), "");
  EXPECT_EQ(check(R"({"/list": {"contains": "y"}})"), "");
  EXPECT_EQ(check(R"({"/a/b": 3})"), "/a/b is 2.5, expected 3");
  EXPECT_EQ(check(R"({"/a/b": {"max": 2}})"), "/a/b is 2.5, expected 2 or less");
  EXPECT_EQ(check(R"({"/a/c": 3})"), "/a/c is absent, expected 3");
  EXPECT_EQ(check(R"({"/a/b/c": 3})"), "/a/b/c is absent, expected 3");
  EXPECT_THAT(check(R"({"/text": {"contains": "blue"}})"), HasSubstr("something with \"blue\""));
  EXPECT_THAT(check(R"({"a": 1})"), HasSubstr("is no place in the state"));
  EXPECT_THAT(check(R"({"/a~": 1})"), HasSubstr("is no place in the state"));
}

}  // namespace
}  // namespace orris
