// Names of programs: groups, file names, and the fallback tree. Contract: programs.csv.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/glsl/iris/iris_text.h>
#include <orris/glsl/rewrite/rewrite.h>

namespace orris {

enum class ProgramGroup {
  Setup,
  Begin,
  Shadow,
  ShadowComp,
  Prepare,
  Gbuffers,
  ShadowVolume,  ///< our extension, pack/versions/features.h kShadowVolumes
  Deferred,
  Composite,
  Final,
  DistantHorizons,  ///< the groups from here on are of other mods, see pack/mods/mods.h
  Colorwheel,
  Voxy
};

/// What a file name says: "/world0/composite3_a.csh" is {folder "/world0", program "composite3",
/// group Composite, index 3, stage Compute, computeSuffix 'a'}.
struct ProgramFile {
  std::string folder;
  std::string program;
  ProgramGroup group = ProgramGroup::Gbuffers;
  int index = 0;
  Stage stage = Stage::Fragment;
  char computeSuffix = 0;
};

/// nullopt when the host knows no such program or stage.
std::optional<ProgramFile> parseProgramFile(std::string_view path);

/// Is the group drawn as a fullscreen quad?
bool isFullscreen(ProgramGroup group);

/// Which patcher of Iris takes the stages of the program that draw. Iris: ShaderKey.
IrisProgram irisProgramOf(const ProgramFile& program);

/// The next program to try when `program` is absent ("gbuffers_water" -> "gbuffers_terrain"); "" at
/// a root.
std::string_view fallbackOf(std::string_view program);

/// All names the contract knows in groups Shadow and Gbuffers and of other mods, with their
/// defaults.
struct GeometryProgram {
  std::string_view name;
  std::string_view fallback;
  ProgramGroup group;
};
const std::vector<GeometryProgram>& geometryPrograms();

/// The texture stage of `texture.<stage>.<sampler>`: "gbuffers" for programs of groups Gbuffers and Shadow,
/// "composite" for Final, and so on. Contract: properties.csv texture.*.
std::string textureStageOf(ProgramGroup group);

}  // namespace orris
