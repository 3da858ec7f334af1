#include "check/matrix_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "check/isolated_jobs.h"
#include "check/minimise.h"

namespace orris {
namespace {

using nlohmann::json;

// Packs with one broken option have tens of failures; beyond this they are told without a cause.
constexpr std::size_t kMostCauses = 200;
constexpr int kMinimiseTries = 200, kConditionTries = 200;
constexpr int kLostTries = 12;  // each may take as long as a job is given
constexpr std::chrono::seconds kCauseTime{600};

/// Failures with the same jobs have the same cause.
struct Cluster {
  std::size_t first = 0;  ///< index of a failure
  std::size_t job = 0;    ///< the one of its jobs with the fewest values set
};

std::vector<Cluster> clustersOf(const MatrixPlan& plan, const std::vector<MatrixFailure>& failures,
                                std::vector<std::size_t>& clusterOf) {
  std::vector<Cluster> clusters;
  std::map<std::vector<std::size_t>, std::size_t> byJobs;
  for (std::size_t i = 0; i < failures.size(); ++i) {
    const auto [known, isNew] = byJobs.emplace(failures[i].jobs, clusters.size());
    clusterOf.push_back(known->second);
    if (!isNew) continue;
    const auto settings = [&](std::size_t job) {
      return plan.configurations[plan.jobs[job].configuration].size();
    };
    const auto& jobs = failures[i].jobs;
    clusters.push_back({i, *std::min_element(jobs.begin(), jobs.end(), [&](auto a, auto b) {
                          return settings(a) < settings(b);
                        })});
  }
  return clusters;
}

bool sameProblem(const Diagnostic& a, const Diagnostic& b) {
  return a.id == b.id && a.at.file == b.at.file && a.at.line == b.at.line;
}

std::string explain(const MatrixPlan& plan, MatrixWorker& worker, const MatrixFailure& failure,
                    const MatrixJob& job) {
  const FailsWith fails = [&](const OptionValues& values) {
    if (!failure.lost) {
      const Diagnostics errors = worker.errorsWith(job, values);
      const bool same = std::any_of(errors.begin(), errors.end(),
                                    [&](auto& d) { return sameProblem(d, failure.diagnostic); });
      return same ? Trial::Fails : errors.empty() ? Trial::Good : Trial::FailsOtherwise;
    }
    bool lost = false;
    runIsolated({.count = 1,
                 .workers = 1,
                 .work = [&](std::size_t) { return worker.errorsWith(job, values), ""; }},
                [&](std::size_t, const JobOutcome& outcome) {
                  lost = outcome.kind != JobOutcome::Kind::Done;
                  return true;
                });
    return lost ? Trial::Fails : Trial::Good;
  };
  const OptionSet& options = plan.builds[job.build]->files().options;
  int tries = failure.lost ? kLostTries : kMinimiseTries;
  const OptionValues minimal = minimalValues(plan.configurations[job.configuration], fails, tries);
  const bool isMinimal = tries > 0;
  std::vector<std::string> others;
  if (!failure.lost) others = worker.deciding(job, minimal);
  const Cause cause =
      findCause(options, minimal, others, fails, failure.lost ? kLostTries : kConditionTries);
  const std::string conditions = describe(cause, options);
  if (conditions.empty()) return "fails with the default values";
  const bool exact = isMinimal && cause.complete && !failure.lost;
  return fmt::format("fails if {}{}", exact ? "and only if " : "", conditions);
}

std::string valuesText(const OptionValues& values) {
  constexpr std::size_t kMost = 8;
  std::string text;
  std::size_t count = 0;
  for (const auto& [name, value] : values) {
    if (++count > kMost) return text + fmt::format(" and {} more", values.size() - kMost);
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", name, value);
  }
  return text;
}

std::string where(const MatrixPlan& plan, const MatrixFailure& failure) {
  std::vector<std::string> programs;
  std::set<std::size_t> configurations;
  for (const std::size_t index : failure.jobs) {
    const MatrixJob& job = plan.jobs[index];
    configurations.insert(job.configuration);
    if (!job.entry) continue;
    const std::string& folder = plan.builds[job.build]->folder();
    const std::string name = (folder == "/" ? "" : folder) + "/" + job.entry->name.program;
    if (std::find(programs.begin(), programs.end(), name) == programs.end()) {
      programs.push_back(name);
    }
  }
  const std::string count = fmt::format("{} configuration{}", configurations.size(),
                                        configurations.size() == 1 ? "" : "s");
  if (programs.empty()) return count;
  return fmt::format("via {} ({} program{}, {})", programs.front(), programs.size(),
                     programs.size() == 1 ? "" : "s", count);
}

}  // namespace

void explainFailures(const MatrixPlan& plan, MatrixWorker& worker, int jobs,
                     std::vector<MatrixFailure>& failures) {
  std::vector<std::size_t> clusterOf;
  const std::vector<Cluster> clusters = clustersOf(plan, failures, clusterOf);
  std::vector<std::string> causes(clusters.size());
  const auto work = [&](std::size_t i) {
    return explain(plan, worker, failures[clusters[i].first], plan.jobs[clusters[i].job]);
  };
  runIsolated({.count = std::min(clusters.size(), kMostCauses),
               .workers = jobs,
               .work = work,
               .time = kCauseTime},
              [&](std::size_t i, const JobOutcome& outcome) {
                causes[i] = outcome.result;
                return true;
              });
  for (std::size_t i = 0; i < failures.size(); ++i) {
    const Cluster& cluster = clusters[clusterOf[i]];
    std::string cause = causes[clusterOf[i]];
    if (cause.empty()) {
      const MatrixJob& job = plan.jobs[cluster.job];
      cause = "fails with " + valuesText(plan.configurations[job.configuration]);
    }
    failures[i].diagnostic.notes.push_back(cause + "; " + where(plan, failures[i]));
    if (failures[i].diagnostic.id == "directive-error") {
      failures[i].diagnostic.hint = "the pack itself refuses these values with #error";
    }
  }
}

}  // namespace orris
