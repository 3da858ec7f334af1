#include "app/lsp/check_service.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

namespace orris {
namespace {

using nlohmann::json;

/// Said by a check that has ended well and waits to take over.
constexpr std::string_view kReady = "ready";

bool writeWhole(int to, const void* data, std::size_t size) {
  for (const char* at = static_cast<const char*>(data); size > 0;) {
    const ssize_t count = ::write(to, at, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    at += count;
    size -= std::size_t(count);
  }
  return true;
}

bool readWhole(int from, void* data, std::size_t size) {
  for (char* at = static_cast<char*>(data); size > 0;) {
    const ssize_t count = ::read(from, at, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    at += count;
    size -= std::size_t(count);
  }
  return true;
}

std::optional<CheckJob> readJob(int from) {
  std::uint64_t size = 0;
  if (!readWhole(from, &size, sizeof size)) return std::nullopt;
  std::vector<std::uint8_t> bytes(size);
  if (!readWhole(from, bytes.data(), bytes.size())) return std::nullopt;
  const json value = json::from_cbor(bytes);
  return CheckJob{value.at("number"), value.at("overlay").get<Overlay>(),
                  value.at("changed").get<std::set<std::string>>()};
}

std::string lineOf(const json& message) {
  return message.dump(-1, ' ', true, json::error_handler_t::replace) + '\n';
}

/// The check in progress, seen from the process that rests.
struct Running {
  pid_t process = -1;
  int socket = -1;
  int job = 0;
  std::string read;
};

class Service {
 public:
  Service(const std::string& path, const ValidateOptions& options, int jobs, int out)
      : path_(path), options_(options), jobs_(jobs), out_(out) {
    // Whoever sends jobs may be busy with that: this process never waits for it to read.
    ::fcntl(out_, F_SETFL, ::fcntl(out_, F_GETFL) | O_NONBLOCK);
  }

  void run() {
    while (!ended_) {
      // Its fork goes on, and waits for this end: what is known here is not freed piece by piece.
      if (ready_ && toSay_.empty()) ::_exit(0);
      pollfd all[] = {{.fd = jobs_, .events = POLLIN, .revents = 0},
                      {.fd = running_.socket, .events = POLLIN, .revents = 0},
                      {.fd = toSay_.empty() ? -1 : out_, .events = POLLOUT, .revents = 0}};
      if (::poll(all, std::size(all), -1) < 0 && errno != EINTR) return;
      if (all[2].revents != 0) say();
      if (all[1].revents != 0) listen();
      if (all[0].revents != 0) begin();
    }
  }

 private:
  void begin() {
    const auto job = readJob(jobs_);
    giveUp();
    if (!job) {
      ended_ = true;
      return;
    }
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return lose(job->number);
    const pid_t child = ::fork();
    if (child < 0) {
      ::close(ends[0]);
      ::close(ends[1]);
      return lose(job->number);
    }
    if (child == 0) {
      ::setpgid(0, 0);
      ::close(ends[0]);
      toSay_.clear();
      return check(*job, ends[1]);
    }
    ::setpgid(child, child);
    ::close(ends[1]);
    running_ = {child, ends[0], job->number, ""};
  }

  /// In the fork, which then rests in place of the process that it was forked from.
  void check(const CheckJob& job, int socket) {
    const auto tell = [&](json message) {
      message["job"] = job.number;
      const std::string line = lineOf(message);
      if (!writeWhole(socket, line.data(), line.size())) ::_exit(1);
    };
    checkForEditor(path_, options_, job, memory_, tell);
    tell({{"part", kReady}});
    char unused = 0;
    readWhole(socket, &unused, 1);  // until that process has ended
    ::close(socket);
  }

  void listen() {
    char bytes[1 << 16];
    const ssize_t count = ::read(running_.socket, bytes, sizeof bytes);
    if (count < 0 && errno == EINTR) return;
    if (count <= 0) {
      const int job = running_.job;
      giveUp();
      return lose(job);
    }
    running_.read.append(bytes, std::size_t(count));
    const std::size_t end = running_.read.rfind('\n');
    if (end == std::string::npos) return;
    std::string lines = running_.read.substr(0, end + 1);
    running_.read.erase(0, end + 1);
    // The last line, written last.
    const std::string last = lineOf({{"part", kReady}, {"job", running_.job}});
    if (lines.ends_with(last)) {
      ready_ = true;
      lines.erase(lines.size() - last.size());
    }
    toSay_ += lines;
  }

  void giveUp() {
    ready_ = false;
    if (running_.process < 0) return;
    ::kill(-running_.process, SIGKILL);
    while (::waitpid(running_.process, nullptr, 0) < 0 && errno == EINTR) {
    }
    ::close(running_.socket);
    running_ = {};
  }

  void lose(int job) { toSay_ += lineOf({{"part", "lost"}, {"job", job}}); }

  void say() {
    const ssize_t count = ::write(out_, toSay_.data(), toSay_.size());
    if (count > 0) toSay_.erase(0, std::size_t(count));
    if (count < 0 && errno != EINTR && errno != EAGAIN) {
      giveUp();
      ended_ = true;
    }
  }

  const std::string& path_;
  const ValidateOptions& options_;
  int jobs_, out_;
  CheckMemory memory_;
  Running running_;
  std::string toSay_;
  bool ready_ = false, ended_ = false;
};

}  // namespace

void serveChecks(const std::string& path, const ValidateOptions& options, int jobs, int out) {
  Service(path, options, jobs, out).run();
}

bool writeCheckJob(int to, const CheckJob& job) {
  const std::vector<std::uint8_t> bytes =
      json::to_cbor({{"number", job.number}, {"overlay", job.overlay}, {"changed", job.changed}});
  const std::uint64_t size = bytes.size();
  return writeWhole(to, &size, sizeof size) && writeWhole(to, bytes.data(), bytes.size());
}

}  // namespace orris
