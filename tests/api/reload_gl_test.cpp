// Packs as files that change, and as archives.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "api/api_fixture.h"
#include "support/folder_test.h"

namespace orris_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ReloadApi : public ApiTest {
 protected:
  void SetUp() override {
    ApiTest::SetUp();
    fs::copy(testPack(), folder_ / "pack", fs::copy_options::recursive);
  }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_ / "pack/shaders" / file) << text;
  }
  static std::string finalOf(const std::string& color) {
    return "#version 330 compatibility\n/* RENDERTARGETS: 0 */\nlayout(location = 0) out vec4 color;\n"
           "void main() { color = " +
           color + "; }\n";
  }
  const orris::test::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
};

TEST_F(ReloadApi, edited_files_are_drawn_with) {
  OrrisRenderer* renderer = make(request((folder_ / "pack").string()));
  drawn(renderer);
  write("final.fsh", finalOf("vec4(0.0, 1.0, 0.0, 1.0)"));
  EXPECT_NE(at(drawn(renderer), 3, 3), (Rgb{0, 255, 0})) << "nothing is watched";
  ASSERT_EQ(orris_renderer_reload(renderer), ORRIS_OK) << orris_last_error();
  EXPECT_EQ(at(drawn(renderer), 3, 3), (Rgb{0, 255, 0}));
}

TEST_F(ReloadApi, a_mistake_leaves_the_last_good_pack) {
  OrrisRenderer* renderer = make(request((folder_ / "pack").string()));
  const auto before = drawn(renderer);
  write("final.fsh", finalOf("vec4(missing)"));
  EXPECT_EQ(orris_renderer_reload(renderer), ORRIS_ERROR_PACK);
  EXPECT_THAT(orris_last_error(), HasSubstr("/final.fsh:4"));
  ASSERT_FALSE(messages_.empty());
  EXPECT_EQ(messages_.back().file, "/final.fsh");
  EXPECT_EQ(drawn(renderer), before);
  ASSERT_EQ(orris_renderer_set_option(renderer, "BRIGHTNESS", "0.5"), ORRIS_OK);
  EXPECT_NE(drawn(renderer), before);
}

// Programs of a kind are compiled when it is first submitted; those that fail leave out the kind alone.
TEST_F(ReloadApi, a_program_that_fails_when_it_is_needed_is_reported_once) {
  write("gbuffers_entities.fsh", finalOf("vec4(missing)"));
  OrrisRenderer* renderer = make(request((folder_ / "pack").string()));
  ASSERT_NE(renderer, nullptr) << "nothing needs the program yet";
  std::uint32_t buffer = 0;
  ASSERT_EQ(orris_buffer_create(context_, nullptr, 4 * sizeof(OrrisVertex), &buffer), ORRIS_OK);
  OrrisBatch batch;
  orris_batch_init(&batch, sizeof(batch));
  batch.kind = ORRIS_KIND_ENTITY;
  batch.vertex_buffer = buffer;
  batch.count = 4;
  ASSERT_EQ(orris_renderer_submit(renderer, &batch), ORRIS_OK);
  EXPECT_EQ(orris_renderer_draw_frame(renderer, nullptr), ORRIS_ERROR_PACK);
  EXPECT_THAT(orris_last_error(), HasSubstr("/gbuffers_entities.fsh:4"));
  ASSERT_EQ(orris_renderer_submit(renderer, &batch), ORRIS_OK);
  EXPECT_EQ(orris_renderer_draw_frame(renderer, nullptr), ORRIS_OK);
  read(renderer);
}

TEST_F(ReloadApi, a_zip_is_a_pack) {
  const std::string command = "cd '" + (folder_ / "pack").string() +
                              "' && python3 -m zipfile -c ../pack.zip shaders > /dev/null";
  ASSERT_EQ(std::system(command.c_str()), 0);
  OrrisRenderer *zip = make(request((folder_ / "pack.zip").string())),
                *folder = make(request((folder_ / "pack").string()));
  EXPECT_EQ(drawn(zip), drawn(folder));
}

}  // namespace
}  // namespace orris_test
