#include "app/validate/matrix_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <optional>
#include <utility>

#include "app/input/common.h"

namespace orris {
namespace {

/// GitLab sets these for jobs with `parallel`, counting from 1.
std::optional<Shard> shardOfEnvironment() {
  const char* index = std::getenv("CI_NODE_INDEX");
  const char* total = std::getenv("CI_NODE_TOTAL");
  return index && total ? parseShard(fmt::format("{}/{}", index, total)) : std::nullopt;
}

}  // namespace

void addMatrixFlags(CLI::App& command, MatrixOptions& options) {
  command
      .add_option("--matrix", options.kind,
                  "other option values too: none, each value alone, or each pair of values")
      ->check(CLI::IsMember({"none", "each", "pairwise"}));
  command.add_option("--options", options.options, "vary only these options: NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false);
  addShardFlag(command, options.shard, "part I of N of the matrix: I/N");
  addBudgetFlag(command, options.budget, "end after this time: 60s, 5m");
}

MatrixRequest matrixRequest(const MatrixOptions& options) {
  MatrixRequest request{.kind = *parseMatrixKind(options.kind), .options = options.options};
  const auto shard = options.shard.empty() ? shardOfEnvironment() : parseShard(options.shard);
  if (shard) std::tie(request.shard, request.shards) = *shard;
  return request;
}

std::optional<std::chrono::seconds> matrixTime(const MatrixOptions& options) {
  return parseBudget(options.budget);
}

}  // namespace orris
