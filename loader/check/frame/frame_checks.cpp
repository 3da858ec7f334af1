#include <orris/check/frame/frame_checks.h>

#include <fmt/format.h>

namespace orris {

std::string targetTitle(bool shadow, int index) {
  return fmt::format("{}{}", shadow ? "shadowcolor" : "colortex", index);
}

void checkFrame(const FolderInput& input, Diagnostics& diagnostics) {
  const FrameView frame(input.pack, input.schedule);
  checkTargetsRead(frame, diagnostics);
  checkTargetsWritten(frame, diagnostics);
  checkFeedback(frame, diagnostics);
  checkUnboundTargets(frame, diagnostics);
  checkImageStores(frame, diagnostics);
  checkMipmaps(frame, diagnostics);
  checkOutputFormats(frame, diagnostics);
  checkComponents(frame, diagnostics);
}

}  // namespace orris
