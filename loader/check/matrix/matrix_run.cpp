#include <orris/check/matrix/matrix_run.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include <orris/check/matrix/matrix_causes.h>
#include <orris/check/workers/diagnostic_codec.h>
#include <orris/check/workers/isolated_jobs.h>
#include <orris/glsl/compile/validate.h>

namespace orris {
namespace {

using Clock = std::chrono::steady_clock;

// Of the time that a matrix has: when planning ends, when it ends to look for failures without having any, when it does
// so with some that are to be explained, and when their messages are to be there.
constexpr double kPlan = 0.25, kSearchAlone = 0.95, kSearch = 0.7, kMessages = 0.8;

/// What parts problems: place and words, whatever the program and the values.
using ProblemKey = std::tuple<std::string, int, std::string, std::string>;
ProblemKey keyOf(const Diagnostic& d) { return {d.at.file, d.at.line, d.id, d.message}; }

class Run {
 public:
  Run(const MatrixBase& base, const MatrixRequest& request,
      const std::function<void(std::size_t, std::size_t)>& progress)
      : base_(base),
        request_(request),
        progress_(progress),
        plan_(planMatrix(base, request, endOf(kPlan))),
        shapes_(base, plan_),
        seen_(4 * (plan_.jobs.size() + base.verdicts.size()) + 1024),
        worker_(plan_, shapes_, base.environment, seen_),
        stalls_(plan_.jobs.size() + 1024),
        found_(plan_.jobs.size()) {
    for (const auto& [name, program] : shapes_.all()) {
      for (const std::uint64_t unit : program.units) seen_.insert(unit);
    }
  }

  MatrixResult run() {
    compileAll();
    findMessages();
    std::vector<MatrixFailure> failures = group();
    explainFailures(
        {.plan = plan_, .worker = worker_, .jobs = request_.jobs, .until = request_.until},
        failures);
    MatrixResult result;
    for (MatrixFailure& failure : failures) {
      result.diagnostics.push_back(std::move(failure.diagnostic));
    }
    result.configurations = plan_.configurations.size() + plan_.left;
    result.all = plan_.all;
    result.tried = tried();
    result.variants = done_;
    result.compiled = compiled_;
    result.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    return result;
  }

 private:
  struct JobResult {
    bool done = false;
    JobOutcome lost;  ///< Kind::Done unless the worker died
    MatrixFinding finding;
  };

  // A program that stalls under one set of values may stall under thousands.
  std::uint64_t programKey(const MatrixJob& job) const {
    return std::hash<std::string>()(job.entry ? job.entry->name.program : "") * 31 + job.build + 1;
  }

  /// The moment when `part` of the time has gone.
  std::optional<Clock::time_point> endOf(double part) const {
    if (!request_.until) return std::nullopt;
    return start_ + std::chrono::duration_cast<Clock::duration>((*request_.until - start_) * part);
  }

  void compileAll() {
    const auto work = [this](std::size_t i) {
      if (stalls_.contains(programKey(plan_.jobs[i]))) return encode(MatrixFinding());
      return encode(worker_.run(plan_.jobs[i]));
    };
    IsolatedJobs jobs{.count = plan_.jobs.size(), .workers = request_.jobs, .work = work};
    jobs.until = endOf(kSearchAlone);
    runIsolated(jobs, [&](std::size_t i, JobOutcome outcome) {
      take(i, std::move(outcome));
      if (anyErrors_) jobs.until = endOf(kSearch);
      return true;
    });
  }

  void take(std::size_t i, JobOutcome outcome) {
    JobResult& result = found_[i];
    result.done = true;
    if (outcome.kind == JobOutcome::Kind::Done) {
      result.finding = decodeFinding(outcome.result);
      compiled_ += static_cast<std::size_t>(result.finding.compiled);
      for (const auto& [unit, errors] : result.finding.failing) failing_.emplace(unit, i);
      anyErrors_ = anyErrors_ || !failing_.empty() || !result.finding.errors.empty();
    } else {
      if (outcome.kind == JobOutcome::Kind::TimedOut) stalls_.insert(programKey(plan_.jobs[i]));
      outcome.result.clear();
      result.lost = std::move(outcome);
    }
    progress_(++done_, plan_.jobs.size());
  }

  std::size_t tried() const {
    std::set<std::size_t> open;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      if (!found_[i].done) open.insert(plan_.jobs[i].configuration);
    }
    return plan_.configurations.size() - open.size();
  }

  // Which process came first to a text must not decide what is reported of it: the first job does.
  void findMessages() {
    struct Unit {
      std::uint64_t shape;
      std::size_t job, index;
    };
    std::vector<Unit> others;
    std::set<std::uint64_t> known;
    for (std::size_t i = 0; i < found_.size(); ++i) {
      const UnitShapes& units = found_[i].finding.units;
      for (std::size_t u = 0; u < units.size(); ++u) {
        const std::uint64_t unit = units[u];
        const auto failing = failing_.find(unit);
        if (failing == failing_.end() || !known.insert(unit).second) continue;
        messagesOf_[unit] = found_[failing->second].finding.failing.at(unit);
        if (failing->second != i) others.push_back({unit, i, u});
      }
    }
    const auto work = [&](std::size_t i) {
      return encodeDiagnostics(worker_.unitErrors(plan_.jobs[others[i].job], others[i].index));
    };
    runIsolated(
        {.count = others.size(), .workers = request_.jobs, .work = work, .until = endOf(kMessages)},
        [&](std::size_t i, const JobOutcome& outcome) {
          if (outcome.kind == JobOutcome::Kind::Done) {
            messagesOf_[others[i].shape] = decodeDiagnostics(outcome.result);
          }
          return true;
        });
    for (auto& [unit, messages] : messagesOf_) keepFirstOfLine(messages);
  }

  // What a compiler says next about a line follows from what it said first.
  static void keepFirstOfLine(Diagnostics& diagnostics) {
    std::set<std::pair<std::string, int>> lines;
    std::erase_if(diagnostics,
                  [&](const Diagnostic& d) { return !lines.emplace(d.at.file, d.at.line).second; });
  }

  std::vector<MatrixFailure> group() {
    std::set<ProblemKey> reported;
    for (const Diagnostic& diagnostic : base_.reported) reported.insert(keyOf(diagnostic));
    std::map<ProblemKey, MatrixFailure> failures;
    const auto add = [&](const Diagnostic& diagnostic, std::size_t job, bool lost) {
      const ProblemKey key = keyOf(diagnostic);
      if (reported.contains(key)) return;
      MatrixFailure& failure = failures[key];
      if (failure.jobs.empty()) failure.diagnostic = diagnostic;
      failure.lost = lost;
      if (failure.jobs.empty() || failure.jobs.back() != job) failure.jobs.push_back(job);
    };
    for (std::size_t i = 0; i < found_.size(); ++i) {
      for (const Diagnostic& diagnostic : found_[i].finding.errors) add(diagnostic, i, false);
      for (const std::uint64_t hash : found_[i].finding.units) {
        const auto known = messagesOf_.find(hash);
        if (known == messagesOf_.end()) continue;
        for (const Diagnostic& diagnostic : known->second) add(diagnostic, i, false);
      }
      if (found_[i].lost.kind != JobOutcome::Kind::Done) add(lostDiagnostic(i), i, true);
    }
    std::vector<MatrixFailure> result;
    for (auto& [key, failure] : failures) result.push_back(std::move(failure));
    return result;
  }

  Diagnostic lostDiagnostic(std::size_t i) const {
    const ProgramEntry* entry = plan_.jobs[i].entry;
    const std::string file = !entry                  ? kPropertiesFile
                             : entry->stages.empty() ? entry->computes.front().second
                                                     : entry->stages.back().second;
    return lostJob(found_[i].lost, "the compiler", entry ? entry->name.program : "the properties",
                   file);
  }

  const MatrixBase& base_;
  const MatrixRequest& request_;
  const std::function<void(std::size_t, std::size_t)>& progress_;
  Clock::time_point start_ = Clock::now();
  MatrixPlan plan_;
  BaseShapes shapes_;
  SharedHashes seen_;
  MatrixWorker worker_;
  SharedHashes stalls_;
  std::vector<JobResult> found_;
  std::map<std::uint64_t, std::size_t> failing_;  ///< unit to the job that compiled it
  bool anyErrors_ = false;
  std::map<std::uint64_t, Diagnostics> messagesOf_;
  std::size_t done_ = 0, compiled_ = 0;
};

}  // namespace

MatrixResult runMatrix(const MatrixBase& base, const MatrixRequest& request,
                       const std::function<void(std::size_t, std::size_t)>& progress) {
  return Run(base, request, progress).run();
}

}  // namespace orris
