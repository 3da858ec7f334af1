#include "app/view/surface/view_controls.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace orris {
namespace {

struct MoveKey {
  int key;
  int FlyKeys::*axis;
  int direction;
};
constexpr MoveKey kMoves[] = {
    {GLFW_KEY_W, &FlyKeys::forward, 1}, {GLFW_KEY_S, &FlyKeys::forward, -1},
    {GLFW_KEY_D, &FlyKeys::right, 1},   {GLFW_KEY_A, &FlyKeys::right, -1},
    {GLFW_KEY_SPACE, &FlyKeys::up, 1},  {GLFW_KEY_LEFT_SHIFT, &FlyKeys::up, -1}};

}  // namespace

void ViewControls::takeKey(const ViewEvent& event, ViewInput& input) {
  if (!event.pressed) {
    down_.erase(event.code);
    return;
  }
  down_.insert(event.code);
  for (const KeyRow& row : keyRows())
    if (row.key == event.code) input.commands.push_back(row.command);
  if (event.code >= GLFW_KEY_1 && event.code <= GLFW_KEY_9) input.camera = event.code - GLFW_KEY_1;
  if (event.code != GLFW_KEY_ESCAPE) return;
  input.close |= !holdsMouse_;
  holdsMouse_ = false;
}

ViewInput ViewControls::take(const std::vector<ViewEvent>& events, const InputTaken& taken) {
  ViewInput input;
  for (const ViewEvent& event : events) {
    switch (event.kind) {
      case ViewEvent::Kind::Key:
        // A key let go is up, whoever it was meant for.
        if (!taken.keys || !event.pressed) takeKey(event, input);
        break;
      case ViewEvent::Kind::Move:
        if (holdsMouse_) {
          input.lookX += event.x - x_;
          input.lookY += event.y - y_;
        }
        x_ = event.x;
        y_ = event.y;
        break;
      case ViewEvent::Kind::Button:
        if (event.pressed && !taken.mouse) holdsMouse_ = true;
        break;
      case ViewEvent::Kind::Scroll:
        if (!taken.mouse) input.scroll += event.y;
        break;
      case ViewEvent::Kind::Close:
        input.close = true;
        break;
      case ViewEvent::Kind::Text:
        break;
    }
  }
  for (const MoveKey& move : kMoves)
    if (down_.contains(move.key)) input.keys.*move.axis += move.direction;
  return input;
}

}  // namespace orris
