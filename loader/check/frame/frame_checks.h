// Checks of the frame: what it draws for nobody, reads before anything is there, and what gets in its
// own way.
#pragma once

#include <orris/check/frame/frame_view.h>
#include <orris/check/pack/pack_checks.h>

namespace orris {

/// All checks below over one folder.
void checkFrame(const FolderInput& input, Diagnostics& diagnostics);

/// target-unread: a buffer that a program draws to and that no file of the pack mentions otherwise.
void checkTargetsRead(const FrameView& frame, Diagnostics& diagnostics);

/// target-unwritten: a buffer that is read while nothing can be in it but its clear colour.
void checkTargetsWritten(const FrameView& frame, Diagnostics& diagnostics);

/// target-feedback: a geometry program samples the very texture that it draws to.
void checkFeedback(const FrameView& frame, Diagnostics& diagnostics);

/// target-unbound: a geometry program samples one of the buffers that it does not get.
void checkUnboundTargets(const FrameView& frame, Diagnostics& diagnostics);

/// target-store-lost, target-store-race: images of a buffer that the same program draws to or samples.
void checkImageStores(const FrameView& frame, Diagnostics& diagnostics);

/// mipmap-missing, mipmap-unused: levels that are read but never made, and the reverse.
void checkMipmaps(const FrameView& frame, Diagnostics& diagnostics);

/// output-format: an output whose numbers the format of its buffer cannot take.
void checkOutputFormats(const FrameView& frame, Diagnostics& diagnostics);

/// format-narrow: a component is read that the format of the buffer has not.
void checkComponents(const FrameView& frame, Diagnostics& diagnostics);

}  // namespace orris
