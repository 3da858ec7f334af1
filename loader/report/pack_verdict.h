// What was checked of one pack, as text and as JSON.
#pragma once

#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include <orris/core/exit_status.h>
#include <orris/core/files/file_source.h>

namespace orris {

/// Programs by name, counted once whatever the number of profiles.
struct ProgramVerdicts {
  std::set<std::string> all, failed;
};

/// What ran, for one profile ("" for the values as they are).
struct MatrixSummary {
  std::string kind, profile;
  int shard = 1, shards = 1;
  std::size_t configurations = 0, tried = 0, variants = 0, compiled = 0;
  bool all = true;  ///< false: of the configurations not all were counted
  double seconds = 0;
};

/// What was checked of one pack.
struct PackVerdict {
  std::string path;
  std::shared_ptr<const FileSource> files;  ///< nullptr: the pack could not be opened
  ProgramVerdicts programs;
  std::map<std::string, ProgramVerdicts> modPrograms;  ///< by name of the mod, "Distant Horizons"
  std::set<std::string> dimensions, profiles;
  std::vector<MatrixSummary> matrices;  ///< one for each profile
  std::set<std::size_t> ofMatrix;       ///< problems of the report that only other options have
  int status = kClean;
  bool cached = false;  ///< of an earlier run (result_cache.h)
};

/// A line with the counts, and one for each program that failed.
std::string toText(const PackVerdict& verdict);
nlohmann::json toJson(const PackVerdict& verdict);

}  // namespace orris
