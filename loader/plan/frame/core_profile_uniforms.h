// Uniforms of the texts for a core-profile context: what a compatibility context keeps as its own
// state (glsl/rewrite/core_names.h).
#pragma once

#include <orris/plan/frame/uniforms.h>

namespace orris {

/// nullptr: no such uniform. Its rows are no input of custom uniforms.
const UniformRow* findCoreUniform(std::string_view name);

/// Texture coordinates of the light level: 16 L becomes (16 L + 8) / 256. Contract: uniforms.csv.
glm::mat4 lightTextureMatrix();

}  // namespace orris
