// Render targets over the frame: written for nobody, read before anything is in them.
#pragma once

#include "check/pack_checks.h"

namespace orris {

/// target-unread: a buffer that a program draws to and that no file of the pack mentions otherwise.
void checkTargetsRead(const FolderInput& input, Diagnostics& diagnostics);

/// target-unwritten: a buffer that is read while nothing can be in it but its clear colour.
void checkTargetsWritten(const FolderInput& input, Diagnostics& diagnostics);

}  // namespace orris
