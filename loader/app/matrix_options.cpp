#include "app/matrix_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <optional>
#include <utility>

#include "app/common.h"
#include "pack/text.h"

namespace orris {
namespace {

std::optional<std::chrono::seconds> parseBudget(const std::string& text) {
  constexpr long long kDay = 24 * 60 * 60;
  if (text.empty()) return std::nullopt;
  const bool minutes = text.back() == 'm';
  const bool unit = minutes || text.back() == 's';
  const auto number = parseInteger(unit ? text.substr(0, text.size() - 1) : text);
  if (!number || *number < 1 || *number > kDay) return std::nullopt;
  return std::chrono::seconds(*number * (minutes ? 60 : 1));
}

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
  command.add_option("--budget", options.budget, "end after this time: 60s, 5m")
      ->check([](const std::string& text) {
        return parseBudget(text) ? std::string() : "expected a time such as 60s or 5m: " + text;
      });
}

MatrixRequest matrixRequest(const MatrixOptions& options, int jobs) {
  MatrixRequest request{.kind = *parseMatrixKind(options.kind), .options = options.options};
  const auto shard = options.shard.empty() ? shardOfEnvironment() : parseShard(options.shard);
  if (shard) std::tie(request.shard, request.shards) = *shard;
  request.jobs = jobs;
  return request;
}

std::optional<std::chrono::seconds> matrixTime(const MatrixOptions& options) {
  return parseBudget(options.budget);
}

}  // namespace orris
