#include <orris/chart/scenes/scene_names.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::Optional;

TEST(SceneNames, worlds_cameras_and_rooms_of_one_parity) {
  EXPECT_THAT(parseScenes({"cornell", "h4_house@inside", "random:7:3", "random:2"}),
              Optional(ElementsAre(SceneName{"cornell", ""}, SceneName{"h4_house", "inside"},
                                   SceneName{"random:7", ""}, SceneName{"random:9", ""}, SceneName{"random:11", ""},
                                   SceneName{"random:2", ""})));
}

TEST(SceneNames, of_a_malformed_list_none_is_taken) {
  for (const char* name : {"", "@inside", "random:", "random:x", "random:1:0", "random:1:10001", "random:1:2:3",
                           "random:-1", "random:4294967296"})
    EXPECT_EQ(parseScenes({"cornell", name}), std::nullopt) << name;
}

TEST(SceneNames, differ_as_files) {
  EXPECT_NE(fileStem(SceneName{"a", "b"}), fileStem(SceneName{"a", ""}));
  EXPECT_EQ(fileStem(SceneName{"worlds/../x", ""}).find('/'), std::string::npos);
}

}  // namespace
}  // namespace orris
