// The program the host uses where a pack has none for some geometry: textured, lit by the lightmap.
#pragma once

#include "glsl/validate.h"

namespace orris {

/// `sky`: untextured colour; otherwise atlas times tint times lightmap.
std::vector<StageText> builtinProgram(bool sky);

}  // namespace orris
