// The option matrix: a pack under many option values, each different program compiled once, each
// failure reported once with the values that it needs.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orris/check/compile/program_check.h>
#include <orris/check/matrix/configurations.h>

namespace orris {

struct MatrixRequest {
  MatrixKind kind = MatrixKind::None;
  std::vector<std::string> options;  ///< only these are varied; none: all
  int shard = 1, shards = 1;         ///< every shards-th configuration, from the shard-th
  /// When the matrix has to end, however little was tried; nullopt: no end.
  std::optional<std::chrono::steady_clock::time_point> until{};
  int jobs = 1;
};

/// What is known of the pack with its values in force.
struct MatrixBase {
  std::span<const ShaderPack> folders;  ///< loaded with the same values, with their sources
  MacroDefinitions environment;
  const Verdicts& verdicts;
  const Diagnostics& reported;  ///< what was reported is not reported again
};

struct MatrixResult {
  std::size_t configurations = 0;  ///< of this shard, the values in force left out
  bool all = true;                 ///< false: there are more, but its time ended
  std::size_t tried = 0;           ///< fewer when its time ended
  std::size_t variants = 0;        ///< programs built under other values
  std::size_t compiled = 0;        ///< different ones among them
  double seconds = 0;
  Diagnostics diagnostics;  ///< in the order of files and lines
};

MatrixResult runMatrix(const MatrixBase& base, const MatrixRequest& request,
                       const std::function<void(std::size_t done, std::size_t total)>& progress);

}  // namespace orris
