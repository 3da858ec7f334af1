// The steps of a script that change files, as an author's editor would.
#pragma once

#include <string>

#include "app/view/script/view_script.h"

namespace orris {

/// "write", "replace", "remove" or "rename".
bool isFileStep(const ScriptStep& step);
/// Paths are seen from the current folder. A problem in words, or "".
std::string changeFile(const ScriptStep& step);

}  // namespace orris
