#include "app/drawing/supervised_run.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <utility>

#include <orris/check/workers/sandbox.h>
#include <orris/core/files/read_places.h>
#include <orris/core/process_limits.h>
#include <orris/core/work_record.h>
#include <orris/image/codecs/image_codecs.h>
#include <orris/validate/driver_check.h>

namespace orris {
namespace {

using Clock = std::chrono::steady_clock;

// What ends a command from outside.
constexpr std::array kEndSignals = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGQUIT};

int brokerSocket = -1;  // of the process that draws, while it has to be confined

void limitDrawing(std::size_t memory) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limitTo(RLIMIT_CORE, 0);
  limitTo(RLIMIT_FSIZE, kMostOutputBytes);
  limitAddresses(memory);
}

/// Makes signals wait to be read from a file.
class SignalFile {
 public:
  SignalFile() {
    sigset_t waiting;
    sigemptyset(&waiting);
    for (const int signal : kEndSignals) {
      struct sigaction now {};
      // What is ignored, as under nohup, stays ignored.
      if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler != SIG_IGN)
        sigaddset(&waiting, signal);
    }
    sigaddset(&waiting, SIGCHLD);
    sigprocmask(SIG_BLOCK, &waiting, &before_);
    file_ = signalfd(-1, &waiting, SFD_CLOEXEC | SFD_NONBLOCK);
  }
  ~SignalFile() {
    if (file_ >= 0) close(file_);
    sigprocmask(SIG_SETMASK, &before_, nullptr);
  }
  SignalFile(const SignalFile&) = delete;
  SignalFile& operator=(const SignalFile&) = delete;

  int file() const { return file_; }
  /// The signal to end with, 0: none came.
  int next() const {
    signalfd_siginfo info{};
    while (read(file_, &info, sizeof info) == sizeof info)
      if (int(info.ssi_signo) != SIGCHLD) return int(info.ssi_signo);
    return 0;
  }

 private:
  sigset_t before_{};
  int file_ = -1;
};

struct Ending {
  std::optional<int> status;  ///< of waitpid(); nullopt: it took too long and was killed
  int signal = 0;             ///< that asked this process to end
  std::optional<int> chosen{};  ///< status to return with
};

/// The process that watches.
class Watch {
 public:
  Watch(pid_t process, int socket, const SignalFile& signals, const WorkRecord& record,
        const SupervisedWork& supervised)
      : process_(process),
        socket_(socket),
        signals_(signals),
        record_(record),
        files_(supervised.files),
        attendant_(supervised.attendant),
        endsItself_(supervised.endsItself),
        limit_(frameTimeOf(supervised.limits)) {}

  Ending run() {
    for (;;) {
      int status = 0;
      if (waitpid(process_, &status, WNOHANG) == process_) return {status, endsItself_ ? 0 : signals_.next()};
      if (const int signal = signals_.next()) {
        if (!endsItself_ || std::exchange(passedOn_, true)) return {kill(), signal};
        ::kill(process_, signal);
      }
      if (tooLong()) return kill(), Ending{};
      if (attendant_)
        if (const auto chosen = attendant_->attend()) return kill(), Ending{.chosen = *chosen};
      pollfd polled[] = {{signals_.file(), POLLIN, 0},
                         {socket_, POLLIN, 0},
                         {attendant_ ? attendant_->descriptor() : -1, POLLIN, 0}};
      poll(polled, 3, attendant_ ? kAttendMilliseconds : kTickMilliseconds);
      if ((polled[1].revents & POLLIN) != 0) serveFile(socket_, files_);
      if ((polled[1].revents & POLLHUP) != 0) socket_ = -1;
    }
  }

 private:
  // What the other process says wakes this one at once; the rest, what a user does, waits for a frame at most.
  static constexpr int kTickMilliseconds = 100, kAttendMilliseconds = 16;

  int kill() {
    ::kill(process_, SIGKILL);
    int status = 0;
    while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
  }

  /// One more tick for the piece of work that is being done. A tick that took much longer was one of a
  /// machine or terminal that had stopped both processes.
  bool tooLong() {
    const Clock::time_point now = Clock::now();
    const WorkNote note = record_.read();
    constexpr auto kLongestTick = std::chrono::milliseconds(10 * kTickMilliseconds);
    spent_ += std::min<Clock::duration>(now - last_, kLongestTick);
    last_ = now;
    if (note.idle || note.pieces != pieces_) spent_ = {};
    pieces_ = note.pieces;
    return spent_ > limit_;
  }

  pid_t process_;
  int socket_;
  const SignalFile& signals_;
  const WorkRecord& record_;
  const AllowedFiles& files_;
  Attendant* attendant_;
  bool endsItself_;
  bool passedOn_ = false;  ///< a signal
  Clock::duration limit_, spent_{};
  Clock::time_point last_ = Clock::now();
  std::uint64_t pieces_ = 0;
};

/// Ends this process as the signal would have.
void endBy(int signal) {
  std::signal(signal, SIG_DFL);
  sigset_t only;
  sigemptyset(&only);
  sigaddset(&only, signal);
  sigprocmask(SIG_UNBLOCK, &only, nullptr);
  raise(signal);
}

Diagnostic lost(const Ending& ending, const WorkNote& note, const WorkLimits& limits) {
  const bool late = !ending.status || (WIFSIGNALED(*ending.status) && WTERMSIG(*ending.status) == SIGXCPU);
  const std::string where = note.where().empty() ? "" : " " + note.where();
  Diagnostic diagnostic;
  diagnostic.id = late ? "frame-timeout" : "driver-died";
  diagnostic.at.file = note.file;
  if (late) {
    diagnostic.message =
        fmt::format("the driver took longer than {} s{}", frameTimeOf(limits).count(), where);
    diagnostic.hint = "look for loops and dispatches without end; on a slow machine give more time with "
        "--frame-limit";
    return diagnostic;
  }
  const int status = *ending.status;
  const std::string cause = WIFSIGNALED(status)
                                ? fmt::format("signal {}, {}", WTERMSIG(status), strsignal(WTERMSIG(status)))
                                : fmt::format("exit status {}", WEXITSTATUS(status));
  diagnostic.message = fmt::format("the driver died{} ({})", where, cause);
  diagnostic.hint = "leave out parts of the program until it is drawn: players' drivers may die on the same "
      "lines; or allow more with --memory-limit";
  return diagnostic;
}

bool endedWithStatus(const Ending& ending) {
  return ending.status && WIFEXITED(*ending.status) && WEXITSTATUS(*ending.status) <= kHostFailed;
}

/// In the process that watches.
int finishWatching(const Ending& ending, const WorkNote& note, const WorkLimits& limits,
                   Report& report) {
  if (ending.chosen) return *ending.chosen;
  if (ending.signal != 0) endBy(ending.signal);
  if (endedWithStatus(ending)) _exit(WEXITSTATUS(*ending.status));
  const int signal = ending.status && WIFSIGNALED(*ending.status) ? WTERMSIG(*ending.status) : 0;
  // The terminal sends Ctrl-C to both.
  if (std::find(kEndSignals.begin(), kEndSignals.end(), signal) != kEndSignals.end()) endBy(signal);
  Diagnostics diagnostics = {lost(ending, note, limits)};
  report.add(diagnostics);
  return kHostFailed;
}

bool drawsBySoftware(const SupervisedWork& supervised) {
  return supervised.software || gl::isSoftware(supervised.backend);
}

std::size_t memoryOf(const SupervisedWork& supervised) {
  const auto asked = parseMemory(supervised.limits.memory);
  return asked.value_or(driverMemory(drawsBySoftware(supervised)));
}

}  // namespace

std::optional<std::size_t> parseMemory(const std::string& text) {
  constexpr std::size_t kLeast = std::size_t{64} << 20, kMost = std::size_t{1} << 20;
  if (text.empty() || (text.back() != 'M' && text.back() != 'G')) return std::nullopt;
  const std::string digits = text.substr(0, text.size() - 1);
  if (digits.empty() || digits.size() > 7 ||
      digits.find_first_not_of("0123456789") != std::string::npos)
    return std::nullopt;
  const std::size_t number = std::stoul(digits), bytes = number << (text.back() == 'G' ? 30 : 20);
  if (number > kMost || bytes < kLeast) return std::nullopt;
  return bytes;
}

std::chrono::seconds frameTimeOf(const WorkLimits& limits) {
  return parseBudget(limits.frameTime).value_or(std::chrono::seconds(300));
}

void addLimitFlags(CLI::App& command, WorkLimits& limits) {
  addTimeFlag(command, "--frame-limit", limits.frameTime,
              "end when a frame, a program or loading takes longer, 20s or 5m");
  command
      .add_option("--memory-limit", limits.memory,
                  "addresses that drawing may use, 512M or 8G; default, for software rasterisers: as much "
                  "as the machine has, at least 4G")
      ->type_name("SIZE")
      ->check([](const std::string& text) {
        return parseMemory(text) ? std::string() : "expected a size such as 512M or 8G: " + text;
      });
}

int runSupervised(const SupervisedWork& supervised, Report& report,
                  const std::function<int()>& work) {
  std::array<int, 2> sockets{-1, -1};
  const WorkRecord record;
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, sockets.data()) != 0) return work();
  std::optional<SignalFile> signals(std::in_place);
  noteWork("loading", "", supervised.pack);
  // What is buffered now must not be written by both.
  std::cout.flush();
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) signals.reset();
  if (process < 0) return work();
  if (process > 0) {
    close(sockets[1]);
    const Ending ending = Watch(process, sockets[0], *signals, record, supervised).run();
    signals.reset();
    return finishWatching(ending, record.read(), supervised.limits, report);
  }
  close(sockets[0]);
  signals.reset();
  limitDrawing(memoryOf(supervised));
  if (getppid() != parent) _exit(kHostFailed);  // it ended before this process asked to end with it
  brokerSocket = supervised.confined && drawsBySoftware(supervised) ? sockets[1] : -1;
  return work();
}

void confineDrawing(std::vector<int> keep) {
  if (brokerSocket < 0) return;
  requestFilesFrom(brokerSocket);
  const std::string cache = prepareDriverCache();
  // For pictures that are no PNG. The sandbox knows only where it is installed.
  if (const std::string module = imageCodecsFile(); !module.empty()) addReadPlace(module);
  keep.push_back(brokerSocket);
  closeOpenFiles(std::move(keep));
  enterSandbox(readPlaces(), cache);
}

}  // namespace orris
