// What tests of the C interface share: a context, renderers of the pack tests/packs/engine, pixels.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include <orris/orris.h>

namespace orris_test {

inline std::string testPack(const std::string& name = "engine") {
  return std::string(ORRIS_TEST_DIR) + "/packs/" + name;
}

using Rgb = std::array<int, 3>;

struct Message {
  OrrisSeverity severity;
  std::string id, file, message, hint, text;
  int line, column;
};

class ApiTest : public testing::Test {
 protected:
  static constexpr int kWidth = 64, kHeight = 48;

  void SetUp() override {
    ASSERT_EQ(orris_context_create(nullptr, &context_), ORRIS_OK) << orris_last_error();
  }
  void TearDown() override {
    for (OrrisRenderer* renderer : renderers_)
      EXPECT_EQ(orris_renderer_destroy(renderer), ORRIS_OK);
    if (context_ != nullptr) {
      EXPECT_EQ(orris_context_destroy(context_), ORRIS_OK);
    }
  }

  static void keep(const OrrisDiagnostic* diagnostic, void* user) {
    static_cast<ApiTest*>(user)->messages_.push_back(
        {diagnostic->severity, diagnostic->id, diagnostic->file, diagnostic->message,
         diagnostic->hint, diagnostic->text, diagnostic->line, diagnostic->column});
  }

  OrrisRendererRequest request(const std::string& pack, const char* world = nullptr) {
    pack_ = pack;
    OrrisRendererRequest request;
    orris_renderer_request_init(&request, sizeof(request));
    request.width = kWidth;
    request.height = kHeight;
    request.pack = pack_.c_str();
    request.world = world;
    request.on_diagnostic = keep;
    request.user = this;
    return request;
  }
  OrrisRenderer* make(const OrrisRendererRequest& request) {
    OrrisRenderer* renderer = nullptr;
    EXPECT_EQ(orris_renderer_create(context_, &request, &renderer), ORRIS_OK) << orris_last_error();
    if (renderer != nullptr) renderers_.push_back(renderer);
    return renderer;
  }
  /// Destroyed by the test itself.
  void forget(OrrisRenderer* renderer) { std::erase(renderers_, renderer); }

  static OrrisFrame frameOf(OrrisRenderer* renderer) {
    OrrisFrame frame;
    EXPECT_EQ(orris_renderer_frame_init(renderer, &frame, sizeof(frame)), ORRIS_OK);
    return frame;
  }
  static std::vector<unsigned char> read(OrrisRenderer* renderer, int width = kWidth,
                                         int height = kHeight) {
    std::vector<unsigned char> pixels(static_cast<std::size_t>(width * height * 4));
    EXPECT_EQ(orris_renderer_read(renderer, pixels.data(), pixels.size()), ORRIS_OK)
        << orris_last_error();
    return pixels;
  }
  static Rgb at(const std::vector<unsigned char>& pixels, int x, int y, int width = kWidth) {
    const unsigned char* p = &pixels[static_cast<std::size_t>((y * width + x) * 4)];
    return {p[0], p[1], p[2]};
  }
  /// After a frame as it is.
  static std::vector<unsigned char> drawn(OrrisRenderer* renderer) {
    EXPECT_EQ(orris_renderer_draw_frame(renderer, nullptr), ORRIS_OK) << orris_last_error();
    return read(renderer);
  }

  OrrisContext* context_ = nullptr;
  std::vector<OrrisRenderer*> renderers_;
  std::vector<Message> messages_;
  std::string pack_;
};

}  // namespace orris_test
