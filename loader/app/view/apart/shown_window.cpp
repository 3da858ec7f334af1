#include "app/view/apart/shown_window.h"

#include "app/output/report.h"
#include "app/view/files/open_editor.h"
#include <orris/gl/functions.h>

namespace orris {

bool ShownWindow::open(Diagnostics& diagnostics) {
  if (window_) return true;
  context_ = gl::createContext({.backend = gl::Backend::Glfw,
                                .profile = request_.profile,
                                .width = request_.width,
                                .height = request_.height,
                                .title = "Orris"},
                               diagnostics);
  if (!context_) return false;
  window_ = std::make_unique<ViewWindow>(context_->window(), request_.waitForRefresh);
  return true;
}

bool ShownWindow::drawsElsewhere() const {
  return gl::isSoftwareRenderer(context_->driver().renderer) && gl::isInstalled(gl::Backend::Egl);
}

std::unique_ptr<gl::Context> ShownWindow::takeContext() {
  if (!context_ || drawsElsewhere()) return nullptr;
  window_.reset();
  return std::move(context_);
}

void ShownWindow::attend() {
  sendSize();
  for (const ViewEvent& event : window_->poll()) {
    mayEdit_ |= event.pressed;
    // While a frame takes long, only the last place of the mouse counts.
    const bool moves = event.kind == ViewEvent::Kind::Move;
    if (moves && !unsent_.empty() && unsent_.back().event.kind == ViewEvent::Kind::Move &&
        unsent_.back().kind == WindowNews::Kind::Event)
      unsent_.pop_back();
    unsent_.push_back({.kind = WindowNews::Kind::Event, .event = event});
  }
  flush();
  while (const auto order = receiveOrder(link_.windowEnd())) obey(*order);
}

void ShownWindow::sendSize() {
  int width = 0, height = 0;
  window_->size(width, height);
  if ((width == width_ && height == height_) || !WindowLink::isShowable(width, height)) return;
  width_ = width;
  height_ = height;
  unsent_.push_back({.kind = WindowNews::Kind::Size, .width = width, .height = height, .scale = window_->scale()});
}

void ShownWindow::flush() {
  while (!unsent_.empty() && sendNews(link_.windowEnd(), unsent_.front())) unsent_.pop_front();
}

void ShownWindow::obey(const WindowOrder& order) {
  switch (order.kind) {
    case WindowOrder::Kind::Open:
      width_ = height_ = 0;  // they are sent again
      return window_->holdMouse(false);
    case WindowOrder::Kind::Show:
      return show(order.first, order.second);
    case WindowOrder::Kind::Title:
      return window_->setTitle(order.text);
    case WindowOrder::Kind::HoldMouse:
      return window_->holdMouse(order.first != 0);
    case WindowOrder::Kind::FullScreen:
      return window_->setFullScreen(order.first != 0);
    case WindowOrder::Kind::Edit:
      return edit(order);
  }
}

// Of another size than the window's while that changes.
void ShownWindow::show(int width, int height) {
  unsent_.push_back({.kind = WindowNews::Kind::Shown});
  if (!WindowLink::isShowable(width, height)) return flush();
  if (width != picture_.width || height != picture_.height) {
    picture_ = gl::createTexture(2, *findFormat("RGBA8"), width, height, 1, 1, "picture");
    std::string error;
    framebuffer_ = gl::createFramebuffer({&picture_}, nullptr, "picture", error);
  }
  gl::upload(picture_, GL_RGBA, GL_UNSIGNED_BYTE, link_.pixels());
  int shownWidth = 0, shownHeight = 0;
  window_->size(shownWidth, shownHeight);
  gl::BlitNamedFramebuffer(framebuffer_.id(), 0, 0, 0, width, height, 0, 0, shownWidth, shownHeight,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
  window_->show();
  flush();
}

// A process that was taken over opens no editors that nobody has asked for.
void ShownWindow::edit(const WindowOrder& order) {
  if (!mayEdit_) return;
  mayEdit_ = false;
  const std::string problem = openInEditor(request_.packPath, {.file = order.text, .line = order.first});
  if (!problem.empty()) printText(problem + "\n");
}

}  // namespace orris
