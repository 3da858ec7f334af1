#include "app/view/apart/window_link.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <type_traits>
#include <utility>

namespace orris {
namespace {

constexpr int kMostSide = 16384;
constexpr std::size_t kMostPixels = std::size_t{8192} * 8192, kPixelBytes = 4;
constexpr std::size_t kMostText = 4096;

struct OrderHead {
  WindowOrder::Kind kind;
  int first, second;
};

static_assert(std::is_trivially_copyable_v<WindowNews>);

}  // namespace

WindowLink::WindowLink() {
  std::array<int, 2> ends{-1, -1};
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return;
  window_ = ends[0];
  drawing_ = ends[1];
  // Without a file: one could be cut short while the other process reads. Pages that no picture reaches cost nothing.
  void* memory = mmap(nullptr, kMostPixels * kPixelBytes, PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory != MAP_FAILED) pixels_ = static_cast<unsigned char*>(memory);
}

WindowLink::~WindowLink() {
  for (const int end : {window_, drawing_})
    if (end >= 0) close(end);
  if (pixels_ != nullptr) munmap(pixels_, kMostPixels * kPixelBytes);
}

void WindowLink::closeWindowEnd() {
  if (window_ >= 0) close(std::exchange(window_, -1));
}

bool WindowLink::isShowable(int width, int height) {
  return width > 0 && height > 0 && width <= kMostSide && height <= kMostSide &&
         std::size_t(width) * std::size_t(height) <= kMostPixels;
}

bool sendOrder(int drawingEnd, const WindowOrder& order) {
  const OrderHead head{order.kind, order.first, order.second};
  std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
  bytes += order.text.substr(0, kMostText);
  ssize_t sent = -1;
  do sent = send(drawingEnd, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  while (sent < 0 && errno == EINTR);
  return sent >= 0;
}

std::optional<WindowOrder> receiveOrder(int windowEnd) {
  std::array<char, sizeof(OrderHead) + kMostText> bytes;
  const ssize_t got = recv(windowEnd, bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (got < ssize_t(sizeof(OrderHead))) return std::nullopt;
  OrderHead head;
  std::memcpy(&head, bytes.data(), sizeof head);
  return WindowOrder{head.kind, head.first, head.second,
                     std::string(bytes.data() + sizeof head, std::size_t(got) - sizeof head)};
}

bool sendNews(int windowEnd, const WindowNews& news) {
  return send(windowEnd, &news, sizeof news, MSG_NOSIGNAL | MSG_DONTWAIT) == ssize_t(sizeof news);
}

std::optional<WindowNews> receiveNews(int drawingEnd, int milliseconds) {
  pollfd end{drawingEnd, POLLIN, 0};
  int ready = 0;
  do ready = poll(&end, 1, milliseconds);
  while (ready < 0 && errno == EINTR && milliseconds < 0);
  WindowNews news;
  if (ready <= 0 || recv(drawingEnd, &news, sizeof news, MSG_DONTWAIT) != ssize_t(sizeof news)) return std::nullopt;
  return news;
}

}  // namespace orris
