#include "app/lsp/background_check.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/lsp/check_service.h"

namespace orris {
namespace {

using nlohmann::json;

void closeBoth(const int (&ends)[2]) {
  ::close(ends[0]);
  ::close(ends[1]);
}

/// Not those of other packs, whose processes would never see that the server is gone.
void closeAllBut(int one, int other) {
  const unsigned first = unsigned(std::min(one, other)), second = unsigned(std::max(one, other));
  ::close_range(3, first - 1, 0);
  ::close_range(first + 1, second - 1, 0);
  ::close_range(second + 1, ~0u, 0);
}

}  // namespace

/// false: there can be no process.
bool BackgroundCheck::open() {
  if (jobs_ >= 0) return true;
  int jobs[2], out[2];
  if (::pipe2(jobs, O_CLOEXEC) != 0) return false;
  if (::pipe2(out, O_CLOEXEC) != 0) {
    closeBoth(jobs);
    return false;
  }
  first_ = ::fork();
  if (first_ == 0) {
    ::setpgid(0, 0);
    closeAllBut(jobs[0], out[1]);
    // Nothing that is printed may get between the messages of the protocol.
    const int nowhere = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    ::dup2(nowhere, STDIN_FILENO);
    ::dup2(nowhere, STDOUT_FILENO);
    serveChecks(path_, options_, jobs[0], out[1]);
    ::_exit(0);
  }
  ::close(jobs[0]);
  ::close(out[1]);
  jobs_ = jobs[1];
  out_ = out[0];
  if (first_ < 0) stop();
  return first_ > 0;
}

void BackgroundCheck::start(CheckJob job) {
  job.number = ++number_;
  running_ = open();
  // Where they were killed meanwhile, as for their memory, take() finds out.
  if (running_) writeCheckJob(jobs_, job);
}

void BackgroundCheck::stop() {
  // The last of them sees that there are no more jobs.
  if (jobs_ >= 0) ::close(jobs_);
  if (out_ >= 0) ::close(out_);
  if (first_ > 0)
    while (::waitpid(first_, nullptr, 0) < 0 && errno == EINTR) {
    }
  first_ = -1;
  jobs_ = out_ = -1;
  running_ = false;
  read_.clear();
}

std::vector<json> BackgroundCheck::take() {
  std::vector<json> messages;
  char bytes[1 << 16];
  ssize_t count = 0;
  do count = ::read(out_, bytes, sizeof bytes);
  while (count < 0 && errno == EINTR);
  if (count > 0) read_.append(bytes, std::size_t(count));
  for (std::size_t end = read_.find('\n'); end != std::string::npos; end = read_.find('\n')) {
    json message = json::parse(read_.begin(), read_.begin() + std::ptrdiff_t(end), nullptr, false);
    read_.erase(0, end + 1);
    // Of a job that was given up.
    if (!message.is_object() || message.value("job", 0) != number_) continue;
    running_ = running_ && message.value("part", "") == "programs";
    messages.push_back(std::move(message));
  }
  if (count > 0) return messages;
  if (running_) messages.push_back({{"part", "lost"}});
  stop();
  return messages;
}

}  // namespace orris
