// How messages look: plain in pipes and files, coloured and as wide as the window on a terminal.
#pragma once

#include <string>
#include <string_view>

#include <orris/core/diagnostic.h>

namespace orris {

/// Which messages are shown.
struct Verbosity {
  bool quiet = false;    ///< errors only
  bool verbose = false;  ///< notes too
};
bool isShown(Severity severity, const Verbosity& verbosity);

struct TextStyle {
  bool colour = false;
  int width = 162;        ///< cells of a line; source lines are cut around the caret
  bool openPaths = false;  ///< files as the working folder reaches them, not as the pack names them
};

/// What suits a file descriptor: NO_COLOR and CLICOLOR_FORCE (not empty, not "0") decide on colour, and
/// else whether it is a terminal that is not TERM=dumb.
TextStyle styleOf(int descriptor);

/// "MyPack/shaders" of a pack as it was named on the command line, relative to the working folder where
/// it lies inside; "shaders" of a zip.
std::string shadersFolderOf(const std::string& packPath);

/// The message as text, its id at the end of the first line as compilers name their flags. `folder` is
/// the pack's, for style.openPaths; "" leaves paths as they are.
std::string styledText(Diagnostic diagnostic, const TextStyle& style,
                       const std::string& folder = "");

}  // namespace orris
