// What `orris render` looks at between the passes of a frame: --probe, --check-finite, and --dump and
// --show of a buffer after a pass.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>

#include "app/drawing/render_output.h"
#include "app/input/shown_buffer.h"
#include <orris/render/inspect/finite_check.h>
#include <orris/render/inspect/pixel_probe.h>

namespace orris {

/// "colortex0@composite2": a buffer as it is after a pass. nullopt: a plain buffer.
std::optional<std::pair<std::string, std::string>> splitDumpName(const std::string& name);

/// "X,Y"; nullopt for other texts.
std::optional<std::pair<int, int>> parsePixel(const std::string& text);

/// Nothing asked for: no step is watched.
class FrameProbe {
 public:
  FrameProbe(const RenderOutputs& outputs, FrameRenderer& renderer);
  ~FrameProbe();
  FrameProbe(const FrameProbe&) = delete;
  FrameProbe& operator=(const FrameProbe&) = delete;

  /// Before each frame; pixel and dumps are those of the last one.
  void begin(int frame, bool last);
  /// What was dumped after passes, by the name asked for.
  const PassDumps& dumps() const { return dumps_; }
  /// The chain of the pixel as text, "" where none was asked for.
  std::string text() const;
  nlohmann::json json() const;
  /// A buffer of --show as it was, by the text asked for.
  struct Show {
    ShownBuffer asked;
    std::optional<BufferView> view;
  };
  /// After the last frame.
  const std::map<std::string, Show>& shows();
  Diagnostics findings() const { return finite_ ? finite_->findings() : Diagnostics(); }

 private:
  void after(const Step& step);
  const RenderOutputs& outputs_;
  FrameRenderer& renderer_;
  std::optional<PixelProbe> pixel_;
  std::optional<FiniteCheck> finite_;
  PassDumps dumps_;
  std::map<std::string, Show> shows_;
  int frame_ = 0;
  bool last_ = false;
};

}  // namespace orris
