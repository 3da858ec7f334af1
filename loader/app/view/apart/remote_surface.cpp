#include "app/view/apart/remote_surface.h"

#include <utility>

#include <orris/gl/functions.h>

namespace orris {
namespace {

constexpr int kOpeningMilliseconds = 60'000;

}  // namespace

std::unique_ptr<RemoteSurface> RemoteSurface::open(const WindowLink& link) {
  sendOrder(link.drawingEnd(), {WindowOrder::Kind::Open});
  std::vector<WindowNews> before;  // what the user did while nobody drew
  for (;;) {
    const auto news = receiveNews(link.drawingEnd(), kOpeningMilliseconds);
    if (!news) return nullptr;
    if (news->kind == WindowNews::Kind::Event) before.push_back(*news);
    if (news->kind != WindowNews::Kind::Size) continue;
    std::unique_ptr<RemoteSurface> surface(new RemoteSurface(link, *news));
    surface->waiting_ = std::move(before);
    return surface;
  }
}

RemoteSurface::RemoteSurface(const WindowLink& link, const WindowNews& size)
    : HiddenSurface(size.width, size.height), link_(link), scale_(size.scale) {}

void RemoteSurface::take(const WindowNews& news) {
  if (news.kind == WindowNews::Kind::Shown) {
    showing_ = false;
  } else {
    waiting_.push_back(news);
  }
}

std::vector<ViewEvent> RemoteSurface::poll() {
  while (const auto news = receiveNews(link_.drawingEnd(), 0)) take(*news);
  std::vector<ViewEvent> events;
  for (const WindowNews& news : std::exchange(waiting_, {})) {
    if (news.kind == WindowNews::Kind::Event) {
      events.push_back(news.event);
    } else {
      scale_ = news.scale;
      resize(news.width, news.height);
    }
  }
  return events;
}

void RemoteSurface::waitForWindow() {
  while (showing_) {
    const auto news = receiveNews(link_.drawingEnd(), -1);
    take(news.value_or(WindowNews{.kind = WindowNews::Kind::Shown}));
    if (!news) waiting_.push_back({.kind = WindowNews::Kind::Event, .event = {.kind = ViewEvent::Kind::Close}});
  }
}

void RemoteSurface::show() {
  waitForWindow();
  int width = 0, height = 0;
  size(width, height);
  gl::BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer());
  gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl::ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, link_.pixels());
  showing_ = sendOrder(link_.drawingEnd(), {WindowOrder::Kind::Show, width, height});
}

void RemoteSurface::setTitle(const std::string& title) {
  sendOrder(link_.drawingEnd(), {WindowOrder::Kind::Title, 0, 0, title});
}

void RemoteSurface::holdMouse(bool hold) {
  sendOrder(link_.drawingEnd(), {WindowOrder::Kind::HoldMouse, hold ? 1 : 0});
}

void RemoteSurface::setFullScreen(bool on) {
  sendOrder(link_.drawingEnd(), {WindowOrder::Kind::FullScreen, on ? 1 : 0});
}

// What the window's process has to say about it, it says itself.
std::string RemoteSurface::openEditor(const std::string&, const SourceLocation& at) {
  sendOrder(link_.drawingEnd(), {WindowOrder::Kind::Edit, at.line, 0, at.file});
  return "";
}

}  // namespace orris
