// What a pack uses that the Iris or the game it is checked for does not have yet. A use that the
// preprocessor leaves out, guarded by IRIS_VERSION, MC_VERSION or IRIS_FEATURE_*, is none.
#pragma once

#include <orris/check/interface/declaration_checks.h>

namespace orris {

/// version-newer: uniforms, samplers, images and attributes of one program, and its draw buffers.
void checkNewNames(const ProgramInterface& program, DeclarationReport& report);

/// version-newer: keys, formats and numbers of buffers in shaders.properties.
void checkNewProperties(const FolderInput& input, Diagnostics& diagnostics);

}  // namespace orris
