// The sources as the driver gets them, for people and scripts that look behind the host.
#pragma once

#include <string>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// Makes the folder that --patched names, for a process that cannot do so later; "": there is none.
bool makePatchedFolder(const std::string& folder, Diagnostics& diagnostics);

/// Writes one file a stage, "composite.fsh", into `folder`, which is made when it does not exist.
bool writePatched(const std::string& folder, const ShaderPack& pack, Diagnostics& diagnostics);

/// The same into "`folder`/world0", and beside each text "composite.fsh.map": for each of its lines
/// the places it came from ("/lib/sky.glsl:12"), macro definitions included, separated by tabs.
bool writePatchedWithMap(const std::string& folder, const ShaderPack& pack, Diagnostics& diagnostics);

}  // namespace orris
