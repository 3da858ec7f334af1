// A pack built again: from files that were edited, or only a part of its programs.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <orris/core/diagnostic.h>
#include <orris/pack/programs/program_builder.h>
#include <orris/pack/shader_pack.h>

namespace orris {

struct RebuildScope {
  /// A build of the same pack, also of its files before an edit: programs that nothing of the edit and no
  /// differing value reaches are taken over. nullptr: none.
  const ShaderPack* earlier = nullptr;
  /// Which programs; empty: all. What is read off all programs (directives) is then of these alone.
  std::function<bool(const ProgramEntry& entry)> wanted{};
};

/// As the functions of shader_pack.h. `rebuilt`, when given, is the number of programs that were not taken over.
std::optional<ShaderPack> loadShaderPack(std::shared_ptr<const FileSource> source,
                                         const LoadRequest& request, const RebuildScope& scope,
                                         Diagnostics& diagnostics, int* rebuilt = nullptr);
/// From the files of `outline`.
std::optional<ShaderPack> rebuildShaderPack(const ShaderPack& outline, const LoadRequest& request,
                                            const RebuildScope& scope, Diagnostics& diagnostics,
                                            int* rebuilt = nullptr);

}  // namespace orris
