// From the command line to what the path tracer takes.
#pragma once

#include <optional>

#include "app/input/common.h"
#include "app/output/report.h"
#include <orris/trace/reference_scene.h>

namespace orris {

/// The world as the reference pack's frame shows it, with the pack's options as `pack` sets them.
/// nullopt: reported.
std::optional<ReferenceScene> openReferenceScene(const PackOptions& pack, const SceneOptions& scene,
                                                 const ImageOptions& image, Report& report);

/// The reference pack with its options in force: only these and its block ids are read. nullopt: reported.
std::optional<ShaderPack> openReferencePack(const PackOptions& options, Report& report);

}  // namespace orris
