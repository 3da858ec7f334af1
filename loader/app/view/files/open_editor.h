// The user's own editor at a place of a pack.
#pragma once

#include <string>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// The command that opens `file` at a line: most editors take +LINE, some FILE:LINE. `editor` is $VISUAL
/// and may have arguments, separated by blanks.
std::vector<std::string> editorCommand(const std::string& editor, const std::string& file, int line);

/// Starts $VISUAL, or $EDITOR, and does not wait for it. A problem in words, or "".
std::string openInEditor(const std::string& packPath, const SourceLocation& at);

}  // namespace orris
