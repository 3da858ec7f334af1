#include "app/output/child_process.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <thread>

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

// 127, as of a shell: there is no such program.
constexpr int kNotFound = 127;

/// 0 when it cannot be started.
pid_t start(std::vector<std::string> arguments, std::FILE* in, std::FILE* out, std::FILE* errors,
            const std::function<void()>& prepare) {
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child != 0) return child > 0 ? child : 0;
  dup2(fileno(in), STDIN_FILENO);
  dup2(fileno(out), STDOUT_FILENO);
  dup2(fileno(errors), STDERR_FILENO);
  if (prepare) prepare();
  execvp(pointers[0], pointers.data());
  _exit(kNotFound);
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
                                    const std::string& input, std::chrono::seconds longest,
                                    const std::function<void()>& prepare) {
  const TemporaryFile in(std::tmpfile()), out(std::tmpfile()), errors(std::tmpfile());
  if (!in || !out || !errors || !put(in.get(), input)) return std::nullopt;
  const pid_t child = start(arguments, in.get(), out.get(), errors.get(), prepare);
  ChildResult result;
  result.exitStatus = child == 0 ? kNotFound : waitFor(child, longest);
  result.missing = result.exitStatus == kNotFound;
  result.output = take(out.get());
  result.errors = take(errors.get());
  return result;
}

}  // namespace orris
