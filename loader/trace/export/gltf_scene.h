// A scene as the path tracer sees it, as a glTF 2.0 file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orris/trace/trace_scene.h>
#include <orris/world/world.h>

namespace orris {

struct GltfInput {
  std::string name;  ///< of the world
  const TraceScene& scene;
  std::vector<std::string> states;  ///< names by palette index
  std::vector<Camera> cameras;
};

/// The two parts of a glTF file. In `json`, buffers[0] has no address yet: it is `binary`.
struct GltfScene {
  std::string json, binary;
};

/// Faces with the atlas, lamps, sun or moon, sky and cameras, in units of radiance of the reference pack. nullopt and a
/// diagnostic that names `file` when it has too much for the format, or its textures cannot be packed.
std::optional<GltfScene> makeGltf(const GltfInput& input, const std::string& file,
                                  Diagnostics& diagnostics);

/// The bytes of a binary file (.glb), and of a text file that holds its buffer (.gltf).
std::string glbFile(const GltfScene& scene);
std::string gltfFile(const GltfScene& scene);

}  // namespace orris
