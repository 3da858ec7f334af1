// A progress line on a terminal for work over a second; nothing when piped or quiet.
#pragma once

#include <chrono>
#include <string>

#include "app/input/common.h"

namespace orris {

class Progress {
 public:
  Progress(std::string what, int total, const OutputOptions& output);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void advance() { advanceTo(done_ + 1); }
  void advanceTo(int done);

 private:
  void print();
  std::string what_;
  int total_, done_ = 0;
  bool shown_ = false, enabled_;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace orris
