// Program files with names that no host reads.
#pragma once

#include <span>

#include <orris/pack/shader_pack.h>

namespace orris {

/// program-file-unknown, program-file-alone, program-folder-unknown.
void checkFileNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
