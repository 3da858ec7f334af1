#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/check/compile/program_text.h>
#include <orris/check/frame/frame_checks.h>

namespace orris {
namespace {

using Kind = FramePass::Kind;

class UnreadCheck {
 public:
  UnreadCheck(const FrameView& frame, Diagnostics& diagnostics)
      : frame_(frame), diagnostics_(diagnostics) {}

  void run() {
    for (const FramePass& pass : frame_.passes)
      for (const BufferUse& use : pass.uses)
        if (use.isTarget()) used_.insert({use.inShadowMap(), use.buffer.index});
    for (const FramePass& pass : frame_.passes) {
      // Without a directive the host chose the buffers, not the author.
      if (pass.program == nullptr || !pass.program->directives.drawBuffers) continue;
      for (const int index : pass.writes) checkBuffer(pass, index);
    }
  }

 private:
  void checkBuffer(const FramePass& pass, int index) {
    const bool shadow = pass.isShadowGroup();
    // colortex0 is what every sampler name that nobody binds reads, and what a frame without a final
    // program shows; a shadow program that needs no colour draws to shadowcolor0 all the same.
    if (index == 0 || pass.kind == Kind::Present) return;
    if (!used_.insert({shadow, index}).second) return;
    const BufferMentions& m = frame_.mentions();
    const bool mentioned = m.pasted || (shadow ? m.shadowColor : m.color).contains(index) ||
                           (shadow ? m.shadowImages : m.colorImages).contains(index);
    if (mentioned) return;
    diagnostics_.push_back(diagnosticAt(
        frame_.pack, Severity::Warning, "target-unread", pass.program->directives.drawBuffersAt,
        fmt::format("{} draws to {}, but no program of the pack reads it", pass.name,
                    targetTitle(shadow, index)),
        "leave it out of the list, or read it"));
  }

  const FrameView& frame_;
  std::set<std::pair<bool, int>> used_;
  Diagnostics& diagnostics_;
};

}  // namespace

void checkTargetsRead(const FrameView& frame, Diagnostics& diagnostics) {
  UnreadCheck(frame, diagnostics).run();
}

}  // namespace orris
