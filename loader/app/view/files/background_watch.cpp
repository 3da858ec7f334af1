#include "app/view/files/background_watch.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace orris {
namespace {

namespace fs = std::filesystem;

// Two looks that see the same are what an editor has finished.
constexpr auto kBetweenLooks = std::chrono::milliseconds(30);
constexpr int kQuietMilliseconds = 1000;
constexpr int kWithoutEventsMilliseconds = 100;
constexpr std::uint32_t kEvents = IN_CREATE | IN_DELETE | IN_MODIFY | IN_CLOSE_WRITE | IN_MOVE | IN_ATTRIB |
                                  IN_DELETE_SELF | IN_MOVE_SELF;

}  // namespace

int BackgroundWatch::openEvents() { return inotify_init1(IN_NONBLOCK | IN_CLOEXEC); }

BackgroundWatch::BackgroundWatch(std::vector<fs::path> roots, int events)
    : roots_(std::move(roots)),
      watch_(roots_),
      events_(events),
      wake_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      thread_([this](const std::stop_token& stop) { look(stop); }) {}

BackgroundWatch::~BackgroundWatch() {
  thread_.request_stop();
  const std::uint64_t one = 1;
  if (wake_ >= 0) [[maybe_unused]] const ssize_t written = write(wake_, &one, sizeof one);
  thread_.join();
  for (const int file : {events_, wake_})
    if (file >= 0) close(file);
}

void BackgroundWatch::look(const std::stop_token& stop) {
  bool unsettled = false;
  while (!stop.stop_requested()) {
    if (!unsettled) {
      watchFolders();
      sleep();
    }
    // After an event, too: a busy folder must not keep a processor busy.
    std::this_thread::sleep_for(kBetweenLooks);
    const std::scoped_lock lock(mutex_);
    const std::vector<std::string> found = watch_.poll();
    changed_.insert(changed_.end(), found.begin(), found.end());
    unsettled = !watch_.settled();
  }
}

void BackgroundWatch::sleep() {
  std::array<pollfd, 2> files{{{events_, POLLIN, 0}, {wake_, POLLIN, 0}}};
  const bool woken = events_ >= 0 && wake_ >= 0;
  poll(files.data(), files.size(), woken ? kQuietMilliseconds : kWithoutEventsMilliseconds);
  std::array<char, 4096> ignored{};
  while (events_ >= 0 && read(events_, ignored.data(), ignored.size()) > 0) {
  }
}

// Adding a folder that is watched already changes nothing.
void BackgroundWatch::watchFolders() {
  if (events_ < 0) return;
  for (const fs::path& folder : watchedFolders(roots_))
    inotify_add_watch(events_, folder.c_str(), kEvents);
}

std::vector<std::string> BackgroundWatch::take() {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock()) return {};
  std::vector<std::string> changed = std::exchange(changed_, {});
  std::ranges::sort(changed);
  changed.erase(std::ranges::unique(changed).begin(), changed.end());
  return changed;
}

void BackgroundWatch::accept(const std::string& path) {
  const std::scoped_lock lock(mutex_);
  watch_.accept(path);
}

}  // namespace orris
