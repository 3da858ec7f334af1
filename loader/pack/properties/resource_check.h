// Are the files there that shaders.properties names?
#pragma once

#include <orris/core/files/file_source.h>
#include <orris/pack/properties/shader_properties.h>

namespace orris {

/// A missing file is a warning (the host goes on without it); a raw texture shorter than its size
/// says, and initial contents longer than their buffer, are errors.
/// Contract: properties.csv texture.*, bufferObject.*; formats.csv pixel_type.
void checkResources(const ShaderProperties& properties, const FileSource& source,
                    Diagnostics& diagnostics);

}  // namespace orris
