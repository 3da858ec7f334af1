// The checks beyond the compiler: each looks at a loaded pack and reports what the compiler cannot
// know. docs/checks.md has a section for each id.
#pragma once

#include <span>
#include <vector>

#include <orris/check/compile/target_limits.h>
#include <orris/core/diagnostic.h>
#include <orris/pack/shader_pack.h>
#include <orris/plan/schedule/schedule.h>

namespace orris {

/// One program folder with its sources, and the frame it makes in a world that has everything.
struct FolderInput {
  const ShaderPack& pack;
  const Schedule& schedule;
  const TargetLimits& target;
};

/// Runs the checks of one folder in a fixed order.
Diagnostics checkFolder(const FolderInput& input);

/// Runs the checks that need the whole pack: all its folders, each loaded with its sources and with
/// the same option values.
Diagnostics checkWholePack(std::span<const ShaderPack> folders);

}  // namespace orris
