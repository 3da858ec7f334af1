// From the files of one program to texts that compile: flatten, preprocess, read directives, rewrite.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/pack/files/include_graph.h>
#include <orris/pack/options/live_options.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// The entry files of one program of one folder.
struct ProgramEntry {
  ProgramFile name;                                           ///< of any of its files
  std::vector<std::pair<Stage, std::string>> stages;          ///< drawing stages, vertex first
  std::vector<std::pair<std::string, std::string>> computes;  ///< name, file; in dispatch order
};

/// The programs of `folder` among `paths`, in frame order then name, those of other mods
/// last. `isEnabled` is
/// asked per file with its name without extension ("world0/composite_a"). Contract:
/// programs.csv, contract/README "Loading order" 6.
std::vector<ProgramEntry> listPrograms(const std::vector<std::string>& paths,
                                       const std::string& folder, bool tessellation,
                                       const std::function<bool(const std::string&)>& isEnabled);

/// What all programs of a folder share while they are built.
struct BuildContext {
  const IncludeGraph& graph;
  const FileLookup& files;
  const ShaderProperties& properties;
  const MacroDefinitions& macros;
  const std::vector<std::string>& optionNames;  ///< sorted
  std::span<const HostName> names{};            ///< that a mod declares for its programs
  std::string voxyPrelude{};                    ///< stands before the code of its programs
  bool irisTexts = false;                       ///< as in LoadRequest
  std::span<const LiveUniform> live{};  ///< that the texts have in place of options
  bool judgedOnly = false;  ///< where Iris's text is made, that for drawing stays empty
};

/// One file of a program preprocessed, nothing rewritten.
struct PreprocessedPart {
  TokenStream stream;
  Diagnostics diagnostics;
  std::vector<unsigned char> optionUses;  ///< as in NameWatch, of BuildContext::optionNames
};

/// The files of a program: its stages, then its compute shaders.
std::size_t partCount(const ProgramEntry& entry);
Stage stageOfPart(const ProgramEntry& entry, std::size_t part);
PreprocessedPart preprocessPart(const ProgramEntry& entry, std::size_t part,
                                const BuildContext& context);
/// `parts` are all those of the program.
ProgramSource finishProgram(const ProgramEntry& entry, const BuildContext& context,
                            std::vector<PreprocessedPart> parts);

}  // namespace orris
