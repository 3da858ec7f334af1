#include <orris/check/matrix/matrix_causes.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include <orris/check/matrix/minimise.h>
#include <orris/check/workers/isolated_jobs.h>

namespace orris {
namespace {

using Clock = std::chrono::steady_clock;

// Packs with one broken option have tens of failures; beyond this they are reported without a cause.
constexpr std::size_t kMostCauses = 200;
constexpr int kMinimiseTries = 200, kConditionTries = 200;
constexpr int kLostTries = 12;  // each may take as long as a job is given
constexpr std::chrono::seconds kCauseTime{600};
constexpr const char* kNotMinimal = " (not minimised for want of time)";

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

/// Does the cause of one failure need these values? Tries them until its time ends.
class Trials {
 public:
  Trials(const CauseSearch& search, const MatrixFailure& failure, const MatrixJob& job)
      : search_(search), failure_(failure), job_(job) {}

  Trial operator()(const OptionValues& values) {
    cut_ = cut_ || isOver();
    if (cut_) return Trial::FailsOtherwise;
    return failure_.lost ? lostWith(values) : failsWith(values);
  }
  bool cut() const { return cut_; }

 private:
  // A last try must end, and what was found be handed over.
  static constexpr std::chrono::milliseconds kToFinish{500};

  bool isOver() const { return search_.until && Clock::now() >= *search_.until - kToFinish; }

  Trial failsWith(const OptionValues& values) {
    const Diagnostics errors = search_.worker.errorsWith(job_, values);
    const bool same = std::any_of(errors.begin(), errors.end(), [this](auto& error) {
      return sameProblem(error, failure_.diagnostic);
    });
    return same ? Trial::Fails : errors.empty() ? Trial::Good : Trial::FailsOtherwise;
  }

  Trial lostWith(const OptionValues& values) {
    bool lost = false;
    runIsolated({.count = 1,
                 .workers = 1,
                 .work = [&](std::size_t) { return search_.worker.errorsWith(job_, values), ""; },
                 .until = search_.until},
                [&](std::size_t, const JobOutcome& outcome) {
                  lost = outcome.kind != JobOutcome::Kind::Done;
                  return true;
                });
    return lost ? Trial::Fails : Trial::Good;
  }

  const CauseSearch& search_;
  const MatrixFailure& failure_;
  const MatrixJob& job_;
  bool cut_ = false;
};

std::string explain(const CauseSearch& search, const MatrixFailure& failure, const MatrixJob& job) {
  Trials trials(search, failure, job);
  const FailsWith fails = [&](const OptionValues& values) { return trials(values); };
  const OptionSet& options = search.plan.builds[job.build]->files().options;
  int tries = failure.lost ? kLostTries : kMinimiseTries;
  const OptionValues minimal =
      minimalValues(search.plan.configurations[job.configuration], fails, tries);
  const bool isMinimal = tries > 0;
  std::vector<std::string> others;
  if (!failure.lost && !trials.cut()) others = search.worker.deciding(job, minimal);
  const Cause cause =
      findCause(options, minimal, others, fails, failure.lost ? kLostTries : kConditionTries);
  const std::string conditions = describe(cause, options);
  if (trials.cut()) return "fails with " + valuesText(minimal) + kNotMinimal;
  if (conditions.empty()) return "fails with the default values";
  const bool exact = isMinimal && cause.complete && !failure.lost;
  return fmt::format("fails if {}{}", exact ? "and only if " : "", conditions);
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

void explainFailures(const CauseSearch& search, std::vector<MatrixFailure>& failures) {
  const MatrixPlan& plan = search.plan;
  std::vector<std::size_t> clusterOf;
  const std::vector<Cluster> clusters = clustersOf(plan, failures, clusterOf);
  std::vector<std::string> causes(clusters.size());
  const auto work = [&](std::size_t i) {
    return explain(search, failures[clusters[i].first], plan.jobs[clusters[i].job]);
  };
  runIsolated({.count = std::min(clusters.size(), kMostCauses),
               .workers = search.jobs,
               .work = work,
               .time = kCauseTime,
               .confined = false,  // starts workers of its own, which are
               .until = search.until},
              [&](std::size_t i, const JobOutcome& outcome) {
                causes[i] = outcome.result;
                return true;
              });
  for (std::size_t i = 0; i < failures.size(); ++i) {
    const Cluster& cluster = clusters[clusterOf[i]];
    std::string cause = causes[clusterOf[i]];
    if (cause.empty()) {
      const MatrixJob& job = plan.jobs[cluster.job];
      cause = "fails with " + valuesText(plan.configurations[job.configuration]) + kNotMinimal;
    }
    failures[i].diagnostic.notes.push_back(cause + "; " + where(plan, failures[i]));
    if (failures[i].diagnostic.id == "directive-error") {
      failures[i].diagnostic.hint = "the pack itself refuses these values with #error";
    }
  }
}

}  // namespace orris
