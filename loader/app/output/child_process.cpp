#include "app/output/child_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <thread>

extern char** environ;

namespace orris {
namespace {

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

/// 0 when it cannot be started.
pid_t start(std::vector<std::string> arguments, std::FILE* in, std::FILE* out, std::FILE* errors) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in), 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(out), 1);
  posix_spawn_file_actions_adddup2(&actions, fileno(errors), 2);
  pid_t child = 0;
  const int error = posix_spawnp(&child, pointers[0], &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? child : 0;
}

std::optional<int> waitFor(pid_t child, std::chrono::seconds longest) {
  const auto end = std::chrono::steady_clock::now() + longest;
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

}  // namespace

std::optional<ChildResult> runChild(const std::vector<std::string>& arguments,
                                    const std::string& input, std::chrono::seconds longest) {
  // 127: a C library that notices the missing program in the child only.
  constexpr int kNotFound = 127;
  const TemporaryFile in(std::tmpfile()), out(std::tmpfile()), errors(std::tmpfile());
  if (!in || !out || !errors || !put(in.get(), input)) return std::nullopt;
  const pid_t child = start(arguments, in.get(), out.get(), errors.get());
  ChildResult result;
  result.exitStatus = child == 0 ? kNotFound : waitFor(child, longest);
  result.missing = result.exitStatus == kNotFound;
  result.output = take(out.get());
  result.errors = take(errors.get());
  return result;
}

}  // namespace orris
