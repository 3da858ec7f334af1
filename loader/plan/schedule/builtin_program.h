// The program the host uses where a pack has none for some geometry: textured, lit by the lightmap.
#pragma once

#include <orris/glsl/compile/validate.h>
#include <orris/plan/schedule/schedule.h>

namespace orris {

/// Sky and clouds know no light.
bool usesBuiltinSky(Geometry geometry);
/// `sky`: texture times colour; otherwise atlas times tint times lightmap.
std::vector<StageText> builtinProgram(bool sky);

}  // namespace orris
