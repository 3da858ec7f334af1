// A GL context behind a handle of the C interface.
#pragma once

#include <memory>
#include <string>

#include <orris/api/call.h>
#include <orris/gl/context.h>
#include <orris/gl/state_guard.h>
#include <orris/render/frame_renderer.h>

struct OrrisContext {
  static constexpr const char* kKind = "OrrisContext";
  std::unique_ptr<orris::gl::Context> gl;
  bool adopted = false;
  int renderers = 0;  ///< that live
  std::shared_ptr<orris::ProgramPool> pool = std::make_shared<orris::ProgramPool>();
};

namespace orris::api {

/// For calls that change no state of the engine.
void makeCurrent(OrrisContext& context);

/// While it lives the context is current, and what an engine had set comes back at its end.
class Current {
 public:
  explicit Current(OrrisContext& context);

 private:
  std::optional<gl::StateGuard> guard_;
};

}  // namespace orris::api
