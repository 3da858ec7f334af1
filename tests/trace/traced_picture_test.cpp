// A picture is taken from its file where it is of the scene, and never from one that is not.
#include <gtest/gtest.h>

#include <filesystem>

#include "cube_scene.h"
#include <orris/image/image.h>
#include <orris/trace/film/traced_picture.h>
#include "support/folder_test.h"

namespace orris {
namespace {

/// Its picture is as bright as `radiance`, noise and all.
ReferenceScene glowingRoom(float radiance) {
  const test::Cubes cubes = test::roomOf({4, 4, 4}, {glm::vec3(0.5f), glm::vec3(radiance)});
  ReferenceScene view{test::sceneOf(cubes), {}, {}};
  view.camera.width = 8;
  view.camera.height = 4;
  view.camera.position = {3, 3, 3};
  view.camera.projectionInverse = glm::mat4(0);
  view.camera.projectionInverse[0][0] = 1;
  view.camera.projectionInverse[1][1] = 0.5f;
  view.camera.projectionInverse[3] = glm::vec4(0, 0, -1, 1);
  return view;
}

class TracedPictures : public test::FolderTest {
 protected:
  bool provide(float radiance, const TraceHooks& hooks = {}) {
    return provideTraced(path_, glowingRoom(radiance), {1, -1}, {.samples = 4}, hooks, diagnostics_);
  }
  float shown() {
    const auto image = readImage(path_, diagnostics_);
    return image ? image->at(3, 2)[0] : -1;
  }

  const std::string path_ = path("scene.exr");
  Diagnostics diagnostics_;
};

TEST_F(TracedPictures, are_taken_from_their_file_where_they_are_of_the_scene) {
  ASSERT_TRUE(provide(2));
  const float first = shown();
  EXPECT_GT(first, 0);
  int passes = 0;
  EXPECT_TRUE(provide(2, {[&passes](double) { ++passes; }, {}}));
  EXPECT_EQ(passes, 0);
  EXPECT_TRUE(provide(3, {[&passes](double) { ++passes; }, {}}));
  EXPECT_GT(passes, 0);
  EXPECT_FLOAT_EQ(shown(), 1.5f * first);
}

// A checkpoint of the new scene lies beside the picture of the old one then.
TEST_F(TracedPictures, of_another_scene_are_traced_anew_though_that_was_stopped_once) {
  ASSERT_TRUE(provide(2));
  const float first = shown();
  int asked = 0;
  EXPECT_FALSE(provide(3, {{}, [&asked] { return ++asked > 1; }}));
  EXPECT_FALSE(std::filesystem::exists(path_));
  ASSERT_EQ(diagnostics_.size(), 1u);
  EXPECT_EQ(diagnostics_[0].message, "tracing was stopped before its limit");
  EXPECT_TRUE(provide(3));
  EXPECT_FLOAT_EQ(shown(), 1.5f * first);
}

}  // namespace
}  // namespace orris
