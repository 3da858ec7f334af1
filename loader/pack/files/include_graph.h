// All files a pack's programs reach through #include, each read once.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <orris/core/files/file_source.h>
#include <orris/glsl/tokens/source_map.h>
#include <orris/pack/options/options.h>

namespace orris {

/// The #include edges between files; they do not depend on options or conditionals.
struct IncludeGraph {
  std::map<std::string, FileLines> files;  ///< every reachable file
  /// File -> line (from 1) -> target; "" for an #include that is in error, which includes nothing.
  std::map<std::string, std::map<int, std::string>> includes;
  /// With an #include in error whose file is known and read: other capitals, a comment behind it.
  std::set<std::string> misnaming;
};

/// Reads `entries` and all that they include. Missing files, cycles, paths that leave the root and
/// malformed lines are located errors with the chain of includes.
/// Contract: options.csv inc.syntax, inc.always, inc.cycle.
IncludeGraph readIncludeGraph(const FileSource& source, const std::vector<std::string>& entries,
                              Diagnostics& diagnostics);

/// The lines of a file with options applied; nullptr: there is no such file.
using FileLookup = std::function<const FileLines*(const std::string& file)>;

/// The entry with its includes in place. An error and no lines when they would be more than
/// limits::kStageLines, or the inclusions more than limits::kStageFiles.
FlatSource flatten(const IncludeGraph& graph, const FileLookup& files, const std::string& entry,
                   Diagnostics& diagnostics);

/// `entry` and all files that it reaches, sorted.
std::vector<std::string> reachableFiles(const IncludeGraph& graph, const std::string& entry);

}  // namespace orris
