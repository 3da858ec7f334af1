// The scene of a frame as the path tracer takes it: same faces, same camera, same sun.
#pragma once

#include <map>
#include <string>

#include <orris/pack/shader_pack.h>
#include <orris/trace/path_tracer.h>
#include <orris/world/world.h>

namespace orris {

struct ReferenceScene {
  TraceScene scene;
  TraceCamera camera;
  glm::vec3 shadowLight{0};  ///< direction to sun or moon, whichever casts
};

/// `pack` is the reference pack, or another with its options (settings.glsl) and block ids; only
/// these are used of it. Unknown blocks are warnings.
ReferenceScene buildReferenceScene(World world, const ShaderPack& pack, const Camera& camera,
                                   int width, int height, Diagnostics& diagnostics);

}  // namespace orris
