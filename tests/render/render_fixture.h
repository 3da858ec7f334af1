// Packs in memory rendered on the software rasteriser, for tests of the frame.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

#include <orris/core/files/file_source.h>
#include <orris/render/session/render_session.h>

namespace orris {

/// A session over files that a test may change between frames.
class RenderTest : public ::testing::Test {
 protected:
  using Files = std::map<std::string, std::string>;

  static void SetUpTestSuite() {
    Diagnostics diagnostics;
    context_ = gl::createContext({}, diagnostics).release();
    for (const Diagnostic& d : diagnostics) ADD_FAILURE() << formatDiagnostic(d);
  }
  static void TearDownTestSuite() { delete std::exchange(context_, nullptr); }
  void TearDown() override {
    session_.reset();
    pool_.reset();
    for (const std::string& message : context_->takeErrors()) ADD_FAILURE() << message;
  }

  static inline const std::string kVertex =
      "#version 330 compatibility\nout vec2 uv;\nvoid main() {\n"
      "  gl_Position = ftransform();\n  uv = gl_MultiTexCoord0.xy;\n}\n";

  /// A pass that copies what there is.
  static inline const std::string kPass =
      "uniform sampler2D colortex0;\nvoid main() { gl_FragColor = texture2D(colortex0, uv); }\n";

  void addProgram(const std::string& name, const std::string& fragment) {
    files_["/" + name + ".vsh"] = kVertex;
    files_["/" + name + ".fsh"] = "#version 330 compatibility\nin vec2 uv;\n" + fragment;
  }

  /// A floor of stone at y = 0 with `extra` on top, seen from above.
  static World floorWorld() {
    World world;
    world.blocks = BlockWorld({-8, 0, -8}, {16, 4, 16});
    world.blocks.fill({-8, 0, -8}, {7, 0, 7},
                      world.blocks.paletteIndex(*parseBlockState("minecraft:stone")));
    Camera camera;
    camera.name = "down";
    camera.position = {0.5, 5.5, 0.5};
    camera.pitch = 90;
    camera.fov = 60;
    world.cameras = {camera};
    return world;
  }

  bool start(World world, int width = 32, int height = 32, LoadRequest load = {}) {
    SessionRequest request;
    request.openPack = [this](Diagnostics&) { return memorySource(files_); };
    request.load = std::move(load);
    request.renderer = {width, height, true, false, pool_};
    request.camera = world.cameras.front();
    diagnostics_.clear();
    session_ = RenderSession::create(*context_, std::move(request), std::move(world), diagnostics_);
    return session_ != nullptr;
  }

  void draw(int frames = 1) {
    for (int i = 0; i < frames; ++i) session_->renderFrame(diagnostics_);
  }

  /// Values of a buffer at a pixel, row 0 at the top.
  std::vector<float> pixel(const std::string& buffer, int x, int y) {
    const auto image = session_->renderer().dump(buffer);
    if (!image) return {};
    return {image->at(x, y), image->at(x, y) + image->channels};
  }

  std::string messages() const {
    std::string text;
    for (const Diagnostic& d : diagnostics_) text += formatDiagnostic(d) + "\n";
    return text;
  }

  static inline gl::Context* context_ = nullptr;
  Files files_;
  std::shared_ptr<ProgramPool> pool_;
  Diagnostics diagnostics_;
  std::unique_ptr<RenderSession> session_;
};

}  // namespace orris
