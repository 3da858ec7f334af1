#include <orris/core/work_stage.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <mutex>

namespace orris {
namespace {

std::mutex stageMutex;
// There may be no memory left to say it in.
std::array<char, 512> failedStage{};

void append(std::size_t& size, std::string_view text) {
  const std::size_t room = failedStage.size() - 1 - size;
  text = text.substr(0, room);
  std::copy(text.begin(), text.end(), failedStage.begin() + static_cast<std::ptrdiff_t>(size));
  size += text.size();
}

}  // namespace

WorkStage::~WorkStage() {
  if (std::uncaught_exceptions() <= exceptions_) return;
  const std::lock_guard lock(stageMutex);
  if (failedStage.front() != '\0') return;
  std::size_t size = 0;
  for (const std::string_view text :
       {std::string_view("while "), doing_, std::string_view(" "), file_})
    append(size, text);
}

std::string WorkStage::whereFailed() {
  const std::lock_guard lock(stageMutex);
  return failedStage.data();
}

}  // namespace orris
