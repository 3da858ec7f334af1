// Custom textures and images of shaders.properties that no program looks at.
#pragma once

#include <span>

#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// texture-unused, image-unused (notes): no file of the pack names the sampler or image.
void checkTexturesUsed(std::span<const ShaderPack> folders, Diagnostics& diagnostics);

}  // namespace orris
