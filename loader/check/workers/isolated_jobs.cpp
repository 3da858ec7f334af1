#include <orris/check/workers/isolated_jobs.h>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <vector>

#include <orris/check/workers/sandbox.h>
#include <orris/core/files/read_places.h>
#include <orris/core/process_limits.h>
#include <orris/core/socket_bytes.h>

namespace orris {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kOutOfMemory = 86;  // exit status of a worker whose job threw
constexpr int kWallFactor = 10;
constexpr auto kGrace = std::chrono::seconds(1);  // for starting a worker and sending its result

rlim_t secondsUsed() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
}

rlim_t secondsOf(const IsolatedJobs& jobs) {
  return static_cast<rlim_t>(std::max<long long>(1, jobs.time.count()) + 1);
}

/// For the next job; the hard limit is that of all jobs.
void limitProcessorTime(const IsolatedJobs& jobs) {
  rlimit limit{};
  getrlimit(RLIMIT_CPU, &limit);
  limit.rlim_cur = std::min(limit.rlim_max, secondsUsed() + secondsOf(jobs));
  setrlimit(RLIMIT_CPU, &limit);
}

void limitProcess(const IsolatedJobs& jobs) {
  constexpr rlim_t kFiles = 256, kFileBytes = rlim_t{1} << 30;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limitTo(RLIMIT_CORE, 0);
  limitTo(RLIMIT_NOFILE, kFiles);
  limitTo(RLIMIT_FSIZE, kFileBytes);
  // The hard limit kills without a word: it comes after that of the last job.
  constexpr rlim_t kMore = 5;
  limitTo(RLIMIT_CPU, secondsUsed() + secondsOf(jobs) * static_cast<rlim_t>(jobs.count) + kMore);
  limitAddresses(jobs.memoryBytes);
}

/// A job has nothing to say but its result.
void silenceOutput(int socket) {
  const int null = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (null >= 0 && socket != STDOUT_FILENO) dup2(null, STDOUT_FILENO);
}

/// The life of a worker: index in, result out, until the socket closes.
[[noreturn]] void serve(int socket, const IsolatedJobs& jobs) {
  limitProcess(jobs);
  silenceOutput(socket);
  closeOpenFiles({socket});
  if (jobs.confined) enterSandbox(readPlaces(), jobs.driver ? prepareDriverCache() : "");
  std::uint64_t index = 0;
  while (receiveAll(socket, &index, sizeof index)) {
    limitProcessorTime(jobs);
    std::string result;
    try {
      result = jobs.work(index);
    } catch (...) {
      _exit(kOutOfMemory);
    }
    const std::uint64_t size = result.size();
    if (!sendAll(socket, &size, sizeof size) || !sendAll(socket, result.data(), size)) break;
  }
  // No destructors: what they would clean up belongs to the parent.
  _exit(0);
}

struct Worker {
  pid_t process = -1;
  int socket = -1;
  bool busy = false;
  std::size_t job = 0;
  std::string received;  ///< of its answer: the length in 8 bytes, then the result
  Clock::time_point deadline;
};

class Pool {
 public:
  Pool(const IsolatedJobs& jobs, const std::function<bool(std::size_t, JobOutcome)>& take)
      : jobs_(jobs), take_(take) {}
  ~Pool() {
    for (Worker& worker : workers_) end(worker, false);
  }

  void run() {
    const auto wanted =
        std::min<std::size_t>(static_cast<std::size_t>(jobs_.workers), jobs_.count);
    for (std::size_t i = 0; i < wanted; ++i) workers_.emplace_back();
    for (Worker& worker : workers_) give(worker);
    while (std::any_of(workers_.begin(), workers_.end(), [](auto& w) { return w.busy; })) {
      if (jobs_.until && Clock::now() >= *jobs_.until) return abandon();
      wait();
    }
  }

 private:
  void abandon() {
    for (Worker& worker : workers_) {
      worker.busy = false;
      end(worker, true);
    }
  }

  bool start(Worker& worker) {
    std::array<int, 2> sockets{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets.data()) != 0) return false;
    // What is buffered now must not be written by the child as well.
    std::cout.flush();
    std::fflush(nullptr);
    const pid_t process = fork();
    if (process == 0) {
      serve(sockets[1], jobs_);
    }
    close(sockets[1]);
    if (process < 0) {
      close(sockets[0]);
      return false;
    }
    worker.process = process;
    worker.socket = sockets[0];
    return true;
  }

  /// The next job for an idle worker; without a process to be had, the job fails.
  void give(Worker& worker) {
    while (!stopped_ && next_ < jobs_.count) {
      const std::uint64_t index = next_++;
      if ((worker.process >= 0 || start(worker)) && sendAll(worker.socket, &index, sizeof index)) {
        worker.busy = true;
        worker.job = index;
        worker.received.clear();
        worker.deadline = Clock::now() + jobs_.time * kWallFactor + kGrace;
        return;
      }
      end(worker, true);
      finish(index, {JobOutcome::Kind::Crashed, "", "no process could be started"});
    }
  }

  void wait() {
    std::vector<pollfd> polled;
    for (const Worker& worker : workers_) {
      polled.push_back({worker.busy ? worker.socket : -1, POLLIN, 0});
    }
    constexpr int kTickMilliseconds = 100;
    poll(polled.data(), polled.size(), kTickMilliseconds);
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      Worker& worker = workers_[i];
      if (!worker.busy) continue;
      if (polled[i].revents != 0) receive(worker);
      if (worker.busy && Clock::now() > worker.deadline) {
        end(worker, true);
        giveUp(worker, {JobOutcome::Kind::TimedOut, "", ""});
      }
    }
  }

  /// Takes what has come, never waits for more.
  void receive(Worker& worker) {
    std::array<char, 1 << 16> block;
    const ssize_t got = recv(worker.socket, block.data(), block.size(), MSG_DONTWAIT);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) return;
    if (got <= 0) return giveUp(worker, causeOf(end(worker, false)));
    worker.received.append(block.data(), static_cast<std::size_t>(got));
    std::uint64_t size = 0;
    if (worker.received.size() < sizeof size) return;
    std::memcpy(&size, worker.received.data(), sizeof size);
    if (size > jobs_.resultBytes) {
      end(worker, true);
      return giveUp(worker, {JobOutcome::Kind::Crashed, "", "a result that is too long"});
    }
    if (worker.received.size() - sizeof size < size) return;
    worker.busy = false;
    finish(worker.job, {JobOutcome::Kind::Done, worker.received.substr(sizeof size, size), ""});
    give(worker);
  }

  void giveUp(Worker& worker, JobOutcome outcome) {
    worker.busy = false;
    finish(worker.job, std::move(outcome));
    give(worker);
  }

  static JobOutcome causeOf(int status) {
    if (WIFSIGNALED(status)) {
      const int signal = WTERMSIG(status);
      if (signal == SIGXCPU) return {JobOutcome::Kind::TimedOut, "", ""};
      return {JobOutcome::Kind::Crashed, "",
              fmt::format("signal {} ({})", signal, strsignal(signal))};
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory) {
      return {JobOutcome::Kind::Crashed, "", "an exception, such as out of memory"};
    }
    return {JobOutcome::Kind::Crashed, "", fmt::format("exit status {}", WEXITSTATUS(status))};
  }

  /// The wait status of the process, which a closed socket ends.
  static int end(Worker& worker, bool byForce) {
    if (worker.process < 0) return 0;
    if (byForce || worker.busy == false) kill(worker.process, SIGKILL);
    close(worker.socket);
    int status = 0;
    while (waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
    }
    worker.process = worker.socket = -1;
    return status;
  }

  void finish(std::size_t index, JobOutcome outcome) {
    if (!take_(index, std::move(outcome))) stopped_ = true;
  }

  const IsolatedJobs& jobs_;
  const std::function<bool(std::size_t, JobOutcome)>& take_;
  std::vector<Worker> workers_;
  std::size_t next_ = 0;
  bool stopped_ = false;
};

void runHere(const IsolatedJobs& jobs, const std::function<bool(std::size_t, JobOutcome)>& take) {
  for (std::size_t i = 0; i < jobs.count; ++i) {
    if (jobs.until && Clock::now() >= *jobs.until) return;
    if (!take(i, {JobOutcome::Kind::Done, jobs.work(i), ""})) return;
  }
}

}  // namespace

void runIsolated(const IsolatedJobs& jobs,
                 const std::function<bool(std::size_t, JobOutcome)>& take) {
  jobs.workers == 0 ? runHere(jobs, take) : Pool(jobs, take).run();
}

}  // namespace orris
