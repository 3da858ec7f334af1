// Trying an #include that seems to be missing: the program is made and compiled with it.
#pragma once

#include "check/missing_include.h"
#include "check/program_check.h"

namespace orris {

/// Does the unit of `pack`, which has `errors`, have fewer with the #include, and none that is new?
bool healsWith(const ShaderPack& pack, const ProgramUnit& unit, const MissingInclude& added,
               const Diagnostics& errors);

}  // namespace orris
