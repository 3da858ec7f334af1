#include <orris/core/files/pack_path.h>

#include <gtest/gtest.h>

namespace orris {
namespace {

using namespace std::string_literals;

TEST(PackPath, resolves_from_the_root_and_from_the_file) {
  EXPECT_EQ(resolvePackPath("/world0/composite.fsh", "/lib/a.glsl"), "/lib/a.glsl");
  EXPECT_EQ(resolvePackPath("/world0/composite.fsh", "a.glsl"), "/world0/a.glsl");
  EXPECT_EQ(resolvePackPath("/composite.fsh", "lib//./a.glsl"), "/lib/a.glsl");
  EXPECT_EQ(resolvePackPath("/world0/composite.fsh", "../lib/a.glsl"), "/lib/a.glsl");
}

TEST(PackPath, refuses_what_leaves_the_root) {
  EXPECT_EQ(resolvePackPath("/composite.fsh", "../a.glsl"), std::nullopt);
  EXPECT_EQ(resolvePackPath("/lib/a.glsl", "../../b.glsl"), std::nullopt);
  EXPECT_EQ(resolvePackPath("/lib/a.glsl", "/../b.glsl"), std::nullopt);
  EXPECT_EQ(resolvePackPath("/lib/a.glsl", "x/../../../lib/b.glsl"), std::nullopt);
}

TEST(PackPath, refuses_empty_paths_and_characters_that_name_other_places) {
  EXPECT_EQ(resolvePackPath("/a", ""), std::nullopt);
  EXPECT_EQ(resolvePackPath("/a", "..\\b"), std::nullopt);
  EXPECT_EQ(resolvePackPath("/a", "b\0c"s), std::nullopt);
}

TEST(PackPath, one_step_above_the_root_is_beside_it_where_that_is_asked_for) {
  const auto beside = [](std::string_view path) {
    return resolvePackPath("/shaders.properties", path, AboveRoot::Beside);
  };
  EXPECT_EQ(beside("../assets/a.png"), "/../assets/a.png");
  EXPECT_EQ(beside("/../assets/./b/../a.png"), "/../assets/a.png");
  EXPECT_EQ(beside("lib/../../assets/a.png"), "/../assets/a.png");
  EXPECT_EQ(beside("/../shaders/lib/a.bin"), "/lib/a.bin");
  EXPECT_EQ(beside("lib/a.bin"), "/lib/a.bin");
  for (const char* outside : {"..", "../..", "../../a.png", "../assets/../../a.png",
                              "/../shaders/../../a.png", "..\\a.png"}) {
    EXPECT_EQ(beside(outside), std::nullopt) << outside;
  }
}

TEST(PackPath, parent_of_a_file_at_the_top_is_the_root) {
  EXPECT_EQ(packPathParent("/world0/composite.fsh"), "/world0");
  EXPECT_EQ(packPathParent("/a"), "/");
}

}  // namespace
}  // namespace orris
