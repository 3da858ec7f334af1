// What the process that draws for `orris view` and the one that owns the window say to each other. The first
// may have been taken over: the second does nothing for it but what is here.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "app/view/surface/view_event.h"

namespace orris {

/// To the window. The first of a process is Open: it knows neither the window's size nor that another one may
/// have drawn there before.
struct WindowOrder {
  enum class Kind { Open, Show, Title, HoldMouse, FullScreen, Edit };
  Kind kind = Kind::Show;
  int first = 0;   ///< Show: width of the picture; HoldMouse, FullScreen: on or off; Edit: line
  int second = 0;  ///< Show: its height
  std::string text{};  ///< Title; Edit: file of the pack
};

/// From the window.
struct WindowNews {
  enum class Kind { Size, Shown, Event };
  Kind kind = Kind::Size;
  int width = 0, height = 0;  ///< Size: of the window in pixels
  float scale = 1;            ///< Size: pixels for one of a display of usual density
  ViewEvent event{};
};

/// Made before the process that draws is forked; each of the two uses its own end.
class WindowLink {
 public:
  WindowLink();
  ~WindowLink();
  WindowLink(const WindowLink&) = delete;
  WindowLink& operator=(const WindowLink&) = delete;

  /// Both have what they need.
  bool usable() const { return pixels_ != nullptr && window_ >= 0; }
  int windowEnd() const { return window_; }
  int drawingEnd() const { return drawing_; }
  /// In the process that draws, which needs no other end: its number may soon be that of another file.
  void closeWindowEnd();
  /// Of the picture: RGBA, rows from the bottom. Room for one that isShowable().
  unsigned char* pixels() const { return pixels_; }

  static bool isShowable(int width, int height);

 private:
  int window_ = -1, drawing_ = -1;
  unsigned char* pixels_ = nullptr;
};

/// Waits until the window takes it; false: it has gone.
bool sendOrder(int drawingEnd, const WindowOrder& order);
/// nullopt: there is none.
std::optional<WindowOrder> receiveOrder(int windowEnd);

/// Never waits; false: the other process has not read the earlier ones.
bool sendNews(int windowEnd, const WindowNews& news);
/// Waits for at most so many milliseconds, -1 for ever. nullopt: nothing came, or, after -1, nothing will.
std::optional<WindowNews> receiveNews(int drawingEnd, int milliseconds);

}  // namespace orris
