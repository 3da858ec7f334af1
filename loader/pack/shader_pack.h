// The loaded pack: an immutable value, no GL in it, no disk access after loading.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <orris/core/files/file_source.h>
#include <orris/glsl/compile/validate.h>
#include <orris/pack/ids/id_map.h>
#include <orris/pack/programs/directives.h>
#include <orris/pack/programs/program_id.h>
#include <orris/pack/programs/program_list.h>
#include <orris/pack/properties/shader_properties.h>
#include <orris/pack/versions/iris_versions.h>

namespace orris {

class FolderBuild;

/// A compute shader of a program, ready to compile.
struct ComputeSource {
  std::string name;  ///< "composite3_a"
  StageText text;
  std::optional<StageText> irisText;  ///< as ProgramSource::irisStages
  ProgramDirectives directives;
  std::array<int, 3> localSize{1, 1, 1};
  std::vector<AppliedRule> rules;
};

/// A program, ready to compile: flattened, preprocessed, rewritten.
struct ProgramSource {
  std::string name;    ///< "composite3"
  std::string folder;  ///< "/world0" or "/"
  ProgramGroup group = ProgramGroup::Gbuffers;
  int index = 0;
  std::vector<StageText> stages;  ///< vertex, [tess, geometry,] fragment; empty if only computes
  /// With LoadRequest::irisTexts what Iris hands to the driver, stage by stage (glsl/iris/iris_text.h);
  /// empty for programs that Iris does not draw.
  std::vector<StageText> irisStages;
  std::vector<ComputeSource> computes;  ///< in dispatch order
  ProgramDirectives directives;
  std::vector<int> drawBuffers;        ///< directive, or the group's default
  std::optional<AlphaTest> alphaTest;  ///< from shaders.properties
  std::optional<BlendMode> blend;
  std::map<std::string, BlendMode> bufferBlend;
  std::array<float, 3> scale{1, 0, 0};
  bool incomplete = false;      ///< an #include of it is in error and counts as empty
  bool misnames = false;        ///< an #include of it is in error, and its file is read all the same
  bool writesFragData = false;  ///< fixed-function alpha test applies (glsl/rewrite/rewrite.h)
  std::map<std::string, bool> flips;  ///< explicit flip.* of this program, canonical buffer names
  std::vector<AppliedRule> rules;
  std::vector<std::string> options;  ///< sorted: those that its text depends on, no other does
  std::vector<std::string> conditionOptions;  ///< of these, those that a condition asks for
  std::vector<ConstLine> constLines;          ///< of the fragment stage
  std::vector<IncludeSite> constSites;        ///< where `constLines` come from
  Diagnostics diagnostics;                    ///< of building it
  /// Hash of all final texts: equal hash, equal GL program.
  std::uint64_t hash = 0;
};

/// What to load: a value for each chosen option and the host's environment.
struct LoadRequest {
  std::string name;         ///< of the pack, for people
  OptionValues values;      ///< must name options and lie in their lists
  std::string profile;      ///< "" for none; applied before `values`
  OptionValues fileValues;  ///< of an option file, applied first; need not lie in the lists
  /// Options that are uniforms in place of macros: of liveOptions() (pack/options/live_options.h).
  std::set<std::string> live{};
  std::string dimension = "minecraft:overworld";  ///< or a folder: "world0", "/world-1", "/"
  MacroDefinitions environment;                   ///< see standardMacros()
  bool buildSources = true;                       ///< false: options, properties and screens only
  bool buildModPrograms = false;                  ///< those of other mods too
  bool irisTexts = false;                         ///< make ProgramSource::irisStages
  /// GLSL types of the host's uniforms by name, for shader code that does not declare them (Voxy).
  std::map<std::string, std::string> uniformTypes{};
  /// Go on after errors for which Iris refuses the whole pack, so that all mistakes are reported.
  bool keepGoing = false;
};

struct ShaderPack {
  std::string name;
  OptionSet options;
  OptionValues values;  ///< every non-default value in force
  std::set<std::string> live;  ///< options that its programs have as uniforms (liveUniform())
  ShaderProperties properties;
  PackDirectives directives;
  bool refused = false;  ///< Iris refuses the pack for one of its directives
  BlockIdMap blockIds;
  std::map<std::string, int> itemIds, entityIds;
  bool hasItemFile = false;  ///< item.properties exists; its absence changes heldItemId
  std::map<std::string, std::map<std::string, std::string>> languages;  ///< "en_us" -> key -> text
  std::string folder;                   ///< program folder in use: "/" or "/world0"
  std::vector<std::string> dimensions;  ///< all program folders: "/", "/world0", ...
  ProgramList programs;  ///< of `folder`, in frame order then name; enabled ones only
  ProgramList
      modPrograms;  ///< those of other mods (pack/mods/mods.h), each as if its mod were there
  std::vector<std::string> disabledPrograms;
  std::map<std::string, FileLines> files;    ///< every file of the include graph, options applied
  MacroDefinitions propertyMacros;           ///< what *.properties files are preprocessed with
  std::shared_ptr<const FileSource> source;  ///< for textures and buffer contents
  /// What the programs were made from: those of the host first, then those of each mod.
  std::vector<std::shared_ptr<const FolderBuild>> builds;

  /// A program by exact name, or through the fallback tree; nullptr when there is none.
  const ProgramSource* find(std::string_view name) const;
  const ProgramSource* resolve(std::string_view name) const;
  /// The author's line, for diagnostics.
  std::string sourceLine(const std::string& file, int line) const;
  /// The profile whose values are in force, "" for custom. Contract: profile.current.
  std::string currentProfile() const;
};

/// Macros of contract/macros.csv. `glVendor`, `glRenderer` and `glExtensions` as the driver names
/// them; biome, stage and category macros included; IRIS_FEATURE_* is added by loadShaderPack.
struct HostDescription {
  std::string glVendor = "Mesa", glRenderer = "llvmpipe";
  std::string system;  ///< "MC_OS_MAC"; "" for the system that this runs on
  std::vector<std::string> glExtensions;
  int glVersion = 450, glslVersion = 450;
  HostVersions versions;
  bool labPbr = false;  ///< the specular maps follow labPBR
  bool iris = true;     ///< false: OptiFine, which has none of the macros of Iris and its mods
};
MacroDefinitions standardMacros(const HostDescription& host);

/// Registry number of a biome as in the BIOME_* macros ("minecraft:plains"); -1 when unknown.
int biomeId(std::string_view name);
/// As in the CAT_* macros; CAT_NONE when unknown.
int biomeCategory(std::string_view name);

/// Loads and prepares everything of one dimension. nullopt when the pack cannot run at all (missing
/// include, cycle, no programs, unsupported required feature, unknown option or profile in the
/// request, value outside its list); errors that concern one program only are diagnostics and the
/// program is still listed. Single-program preprocessing runs on both cores.
std::optional<ShaderPack> loadShaderPack(std::shared_ptr<const FileSource> source,
                                         const LoadRequest& request, Diagnostics& diagnostics);

/// The same pack, from files already read, under other values. Programs of `previous` that the
/// values that differ cannot change are taken over; `rebuilt`, when given, is the number of others.
std::optional<ShaderPack> rebuildShaderPack(const ShaderPack& previous, const LoadRequest& request,
                                            Diagnostics& diagnostics, int* rebuilt = nullptr);

}  // namespace orris
