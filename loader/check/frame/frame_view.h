// What the checks of the frame look at, worked out once for a folder.
#pragma once

#include <optional>
#include <vector>

#include <orris/check/frame/buffer_mentions.h>
#include <orris/check/frame/frame_passes.h>

namespace orris {

class FrameView {
 public:
  FrameView(const ShaderPack& shaderPack, const Schedule& frame)
      : pack(shaderPack), schedule(frame), passes(framePasses(shaderPack, frame)) {}

  /// Looks through all files the first time: ask only when a check is about to speak.
  const BufferMentions& mentions() const {
    if (!mentions_) mentions_ = findBufferMentions(pack);
    return *mentions_;
  }

  const ShaderPack& pack;
  const Schedule& schedule;
  const std::vector<FramePass> passes;

 private:
  mutable std::optional<BufferMentions> mentions_;
};

/// "colortex3" or "shadowcolor3".
std::string targetTitle(bool shadow, int index);

}  // namespace orris
