#include "app/graph.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "app/inputs.h"
#include "check/pass_graph.h"

extern char** environ;

namespace orris {
namespace {

// As validate: decides nothing but sizes in pixels.
constexpr int kWidth = 1920, kHeight = 1080;
constexpr std::chrono::seconds kLongestLayout{120};

using TextForm = std::string (*)(const PassGraph&);
TextForm textForm(const std::string& extension) {
  if (extension == ".json") return toJsonText;
  if (extension == ".dot" || extension == ".gv") return toDot;
  if (extension == ".md") return toMarkdown;
  return nullptr;
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

bool put(std::FILE* file, const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), file) != text.size()) return false;
  return std::fflush(file) == 0 && std::fseek(file, 0, SEEK_SET) == 0;
}

std::string take(std::FILE* file) {
  std::string text;
  char block[65536];
  std::fseek(file, 0, SEEK_SET);
  while (const size_t count = std::fread(block, 1, sizeof block, file)) text.append(block, count);
  return text;
}

/// Starts `dot` without a shell; 0 when it cannot be started.
pid_t startDot(const std::string& format, std::FILE* in, std::FILE* out, std::FILE* errors) {
  std::string program = "dot", argument = "-T" + format;
  char* arguments[] = {program.data(), argument.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in), 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(out), 1);
  posix_spawn_file_actions_adddup2(&actions, fileno(errors), 2);
  pid_t child = 0;
  const int error = posix_spawnp(&child, "dot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? child : 0;
}

/// Exit status of the child; nullopt when it was killed or took too long.
std::optional<int> waitFor(pid_t child) {
  const auto end = std::chrono::steady_clock::now() + kLongestLayout;
  for (int state = 0;;) {
    const pid_t done = waitpid(child, &state, WNOHANG);
    if (done == child) return WIFEXITED(state) ? std::optional(WEXITSTATUS(state)) : std::nullopt;
    if (done < 0 && errno != EINTR) return std::nullopt;
    if (std::chrono::steady_clock::now() > end) {
      kill(child, SIGKILL);
      waitpid(child, &state, 0);
      return std::nullopt;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

std::optional<std::string> layOut(const std::string& dot, const std::string& format, Report& report,
                                  int& status) {
  const TemporaryFile in(std::tmpfile()), out(std::tmpfile()), errors(std::tmpfile());
  status = kHostFailed;
  if (!in || !out || !errors || !put(in.get(), dot)) {
    report.error("file-unwritable", "no temporary file can be made for Graphviz");
    return std::nullopt;
  }
  const pid_t child = startDot(format, in.get(), out.get(), errors.get());
  // 127: a C library that notices the missing program in the child only.
  const std::optional<int> result = child == 0 ? 127 : waitFor(child);
  if (result == 127) {
    report.error("graphviz-missing", "the program dot of Graphviz is not installed",
                 "install graphviz, or write .dot, .md or .json");
    return std::nullopt;
  }
  if (result != 0) {
    report.error("graphviz-failed",
                 fmt::format("dot did not draw the graph: {}",
                             result ? take(errors.get()) : "it was stopped"),
                 "write .dot, .md or .json");
    return std::nullopt;
  }
  status = kClean;
  return take(out.get());
}

}  // namespace

bool writeGraph(const ShaderPack& pack, const std::string& title, const std::string& path,
                Report& report, int& status) {
  const std::string extension = std::filesystem::path(path).extension();
  const TextForm form = path == "-" ? toMarkdown : textForm(extension);
  const bool picture = extension == ".svg" || extension == ".png" || extension == ".pdf";
  if (form == nullptr && !picture) {
    status = kUsage;
    report.error("graph-format-unknown", fmt::format("{} is no form of a graph", path),
                 "write .svg, .png, .pdf, .dot, .json or .md, or - for a table", path);
    return false;
  }
  Diagnostics diagnostics;
  const Schedule schedule = buildSchedule(pack, kWidth, kHeight, {}, diagnostics);
  report.add(diagnostics);
  PassGraph graph = passGraph(pack, schedule);
  graph.pack = title;
  if (path == "-") {
    std::cout << form(graph);
    return true;
  }
  if (!checkWritable(path, report, status)) return false;
  const auto text = picture ? layOut(toDot(graph), extension.substr(1), report, status)
                            : std::optional(form(graph));
  return text && writeWholeFile(path, *text, report, status);
}

}  // namespace orris
