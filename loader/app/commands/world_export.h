// A world as a file for other renderers: the scene of the path tracer.
#pragma once

#include <string>

#include "app/input/common.h"
#include "app/output/report.h"
#include <orris/world/world.h>

namespace orris {

/// Whether an export can be written at `path`: by its ending and its folder. Otherwise reported.
bool checkExportPath(const std::string& path, Report& report);

/// Writes `world`, lit as the reference pack with `pack`'s options lights it.
void exportWorld(World world, const PackOptions& pack, const std::string& path, Report& report);

}  // namespace orris
