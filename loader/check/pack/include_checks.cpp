#include <orris/check/pack/include_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include <orris/core/files/pack_path.h>
#include <orris/pack/files/include_graph.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

template <size_t count>
bool endsInOneOf(std::string_view path, const std::array<std::string_view, count>& ends) {
  return std::any_of(ends.begin(), ends.end(), [&](auto end) { return path.ends_with(end); });
}

bool isStage(std::string_view path) {
  constexpr std::array<std::string_view, 6> kStages{".vsh", ".fsh", ".gsh", ".csh", ".tcs", ".tes"};
  return endsInOneOf(path, kStages);
}

bool isStageOrInclude(std::string_view path) {
  constexpr std::array<std::string_view, 5> kTexts{".glsl", ".inc", ".h", ".frag", ".vert"};
  return isStage(path) || endsInOneOf(path, kTexts);
}

/// A program of Voxy, whose names end in .glsl.
bool isVoxyProgram(std::string_view path) {
  constexpr std::array<std::string_view, 2> kNames{"/voxy_opaque.glsl", "/voxy_translucent.glsl"};
  return endsInOneOf(path, kNames);
}

/// Does a host look for programs in the folder of `path`? Iris, OptiFine: the root and world<n>;
/// dimension.properties names others.
bool isProgramFolder(std::string_view path, const std::vector<std::string>& dimensions) {
  const std::string_view folder = packPathParent(path);
  return folder == "/" || folder.starts_with("/world") ||
         std::find(dimensions.begin(), dimensions.end(), folder) != dimensions.end();
}

/// All files that stage files of program folders reach, those of other hosts and mods among them.
std::set<std::string> reachedFiles(const ShaderPack& pack) {
  std::vector<std::string> roots;
  for (const std::string& path : pack.source->files()) {
    const bool program = isStage(path) || isVoxyProgram(path);
    if (program && isProgramFolder(path, pack.dimensions)) roots.push_back(path);
  }
  // What is wrong with the includes of this host's programs has been reported when they were read.
  Diagnostics ignored;
  std::set<std::string> reached;
  for (const auto& entry : readIncludeGraph(*pack.source, roots, ignored).files) {
    reached.insert(entry.first);
  }
  return reached;
}

}  // namespace

void checkUnusedIncludes(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  const auto reached = reachedFiles(pack);
  for (const std::string& path : pack.source->files()) {
    const bool modFolder = path.starts_with("/photonics/");
    if (!isStageOrInclude(path) || modFolder || reached.contains(path)) continue;
    diagnostics.push_back({.severity = Severity::Note,
                           .id = "include-unused",
                           .at = {.file = path},
                           .message = "no program includes this file"});
  }
}

}  // namespace orris
