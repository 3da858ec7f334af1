// From the files of one program to texts that compile: flatten, preprocess, read directives, rewrite.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "glsl/preprocessor.h"
#include "pack/include_graph.h"
#include "pack/shader_pack.h"

namespace orris {

/// The entry files of one program of one folder.
struct ProgramEntry {
  ProgramFile name;                                           ///< of any of its files
  std::vector<std::pair<Stage, std::string>> stages;          ///< drawing stages, vertex first
  std::vector<std::pair<std::string, std::string>> computes;  ///< name, file; in dispatch order
};

/// The programs of `folder` among `paths`, in frame order then name, those of other mods last. `isEnabled` is
/// asked per file with its name without extension ("world0/composite_a"). Contract:
/// programs.csv, contract/README "Loading order" 6.
std::vector<ProgramEntry> listPrograms(const std::vector<std::string>& paths,
                                       const std::string& folder, bool tessellation,
                                       const std::function<bool(const std::string&)>& isEnabled);

/// What building one program yields besides the program.
struct BuiltProgram {
  ProgramSource source;
  std::vector<ConstLine> constLines;  ///< of the fragment stage
  std::vector<IncludeSite> sites;     ///< of the fragment stage
  Diagnostics diagnostics;
};

/// Of each file, the sorted names of options whose words occur in it.
using Mentions = std::map<std::string, std::vector<std::string>>;

/// What all programs of a pack share while they are built.
struct BuildContext {
  const IncludeGraph& graph;
  const std::map<std::string, FileLines>& files;
  const ShaderProperties& properties;
  const MacroDefinitions& macros;
  const Mentions& mentions;
  std::span<const HostName> names{};  ///< that a mod declares for its programs
};

/// All programs, on two threads; the result does not depend on which thread did what.
std::vector<BuiltProgram> buildPrograms(const std::vector<ProgramEntry>& entries,
                                        const BuildContext& context);

Mentions findMentions(const std::map<std::string, FileLines>& files, const OptionSet& options);

}  // namespace orris
