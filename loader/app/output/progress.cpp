#include "app/output/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <iostream>

#include <orris/core/printable.h>

namespace orris {
namespace {

constexpr auto kPatience = std::chrono::seconds(1);
constexpr auto kInterval = std::chrono::milliseconds(100);

}  // namespace

Progress::Progress(std::string what, int total, const OutputOptions& output)
    : what_(std::move(what)),
      total_(total),
      enabled_(!output.quiet && isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      last_(start_) {}

Progress::~Progress() {
  if (shown_) std::cerr << "\r\x1b[K" << std::flush;
}

void Progress::advanceTo(int done) {
  done_ = std::min(done, total_);
  const auto now = std::chrono::steady_clock::now();
  if (!enabled_ || now - start_ < kPatience || now - last_ < kInterval) return;
  last_ = now;
  print();
}

void Progress::print() {
  constexpr int kWidth = 30;
  const int filled = total_ > 0 ? kWidth * done_ / total_ : 0;
  std::cerr << fmt::format("\r{} [{:<{}}] {}/{}", printable(what_), std::string(filled, '#'), kWidth, done_,
                           total_)
            << std::flush;
  shown_ = true;
}

}  // namespace orris
