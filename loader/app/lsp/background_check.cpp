#include "app/lsp/background_check.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <utility>

#include <orris/report/diagnostic_json.h>
#include <orris/report/findings.h>
#include <orris/validate/validate_pack.h>

namespace orris {
namespace {

using nlohmann::json;

// More programs than this are checked with the rest: it would only be done twice.
constexpr std::size_t kMostInHurry = 60;

json findingJson(const Finding& finding) {
  const Diagnostic& d = finding.diagnostic;
  json value = toJson(Diagnostics{d}).front();
  value["uri"] = finding.uri;
  value["programs"] = finding.programs;
  value["follows"] = finding.follows.size();
  if (d.repair)
    value["repair"] = {{"file", d.repair->file},
                       {"line", d.repair->line},
                       {"text", d.repair->text},
                       {"replaces", d.repair->replaces}};
  return value;
}

json findingsJson(PackVerdict verdict, const ProblemList& problems) {
  json list = json::array();
  const PackResult result = judgePack(std::move(verdict), problems, {}, nullptr);
  // Notes are what `validate` prints only with --verbose.
  for (const Finding& finding : result.findings)
    if (finding.silence == Silence::None && finding.diagnostic.severity != Severity::Note)
      list.push_back(findingJson(finding));
  return list;
}

void sayLine(int out, const json& message) {
  const std::string line =
      message.dump(-1, ' ', true, json::error_handler_t::replace) + '\n';
  for (std::size_t at = 0; at < line.size();) {
    const ssize_t count = ::write(out, line.data() + at, line.size() - at);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) _exit(1);
    at += std::size_t(count);
  }
}

/// Only the programs that read a changed file, without what concerns the frame or the pack.
void checkProgramsFirst(const CheckJob& job, const std::shared_ptr<const FileSource>& files, Checker& checker,
                        int out) {
  const std::set<std::string> stages = affectedStages(*files, job.changed);
  if (stages.empty() || stages.size() > kMostInHurry) return;
  ProblemList problems;
  const auto fewer = onlyStages(files, stages);
  compileFiles(fewer, job.options, checker, problems);
  sayLine(out, {{"part", "programs"},
                {"entries", stages},
                {"findings", findingsJson({.path = job.path, .files = fewer}, problems)}});
}

void work(const CheckJob& job, int out) {
  ProblemList problems;
  Diagnostics diagnostics;
  const std::shared_ptr<const FileSource> opened = openPack(job.path, diagnostics);
  problems.add(diagnostics);
  if (!opened) {
    sayLine(out, {{"part", "whole"}, {"findings", findingsJson({.path = job.path}, problems)}, {"quiet", json::array()}});
    return;
  }
  const auto files = overlaidSource(opened, job.overlay);
  std::set<std::uint64_t> quiet;
  Checker checker{.jobs = job.options.jobs, .target = *job.options.target,
                  .budget = MatrixBudget(std::nullopt, 1), .glslang = job.known, .quiet = &quiet};
  if (!job.changed.empty()) checkProgramsFirst(job, files, checker, out);
  // What was found of some programs is found again, with the rest; what was not is known by now.
  checker.glslang = job.known;
  for (const std::uint64_t hash : quiet) checker.glslang[hash] = true;
  PackVerdict verdict = validateFiles(job.path, files, job.options, checker, problems);
  sayLine(out, {{"part", "whole"}, {"findings", findingsJson(std::move(verdict), problems)}, {"quiet", quiet}});
}

}  // namespace

void BackgroundCheck::start(const CheckJob& job) {
  cancel();
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return;
  const pid_t child = ::fork();
  if (child == 0) {
    ::setpgid(0, 0);
    ::close(ends[0]);
    // Nothing that is printed may get between the messages of the protocol.
    const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    ::dup2(nowhere, STDIN_FILENO);
    ::dup2(nowhere, STDOUT_FILENO);
    work(job, ends[1]);
    _exit(0);
  }
  ::close(ends[1]);
  if (child < 0) {
    ::close(ends[0]);
    return;
  }
  ::setpgid(child, child);
  child_ = child;
  pipe_ = ends[0];
  whole_ = false;
  read_.clear();
}

void BackgroundCheck::cancel() {
  if (child_ > 0) {
    ::kill(-child_, SIGKILL);
    while (::waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  if (pipe_ >= 0) ::close(pipe_);
  child_ = -1;
  pipe_ = -1;
}

std::vector<json> BackgroundCheck::take() {
  std::vector<json> messages;
  char bytes[1 << 16];
  ssize_t count = 0;
  do count = ::read(pipe_, bytes, sizeof bytes);
  while (count < 0 && errno == EINTR);
  if (count > 0) read_.append(bytes, std::size_t(count));
  for (std::size_t end = read_.find('\n'); end != std::string::npos; end = read_.find('\n')) {
    json message = json::parse(read_.begin(), read_.begin() + std::ptrdiff_t(end), nullptr, false);
    read_.erase(0, end + 1);
    if (!message.is_object()) continue;
    whole_ |= message.value("part", "") == "whole";
    messages.push_back(std::move(message));
  }
  if (count <= 0) {
    if (!whole_) messages.push_back({{"part", "lost"}});
    cancel();
  }
  return messages;
}

}  // namespace orris
