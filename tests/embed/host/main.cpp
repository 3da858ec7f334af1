// A host of its own around the library: its context, its world, its pixels. It shows the least that
// a program needs to draw blocks with a shader pack.
#include <iostream>
#include <memory>

#include "core/file_source.h"
#include "gl/context.h"
#include "render/render_session.h"
#include "world/world.h"

namespace {

void print(const orris::Diagnostics& diagnostics) {
  for (const orris::Diagnostic& diagnostic : diagnostics) {
    std::cerr << orris::formatDiagnostic(diagnostic) << '\n';
  }
}

orris::SessionRequest requestFor(const std::string& pack, const orris::World& world) {
  orris::SessionRequest request;
  request.openPack = [pack](orris::Diagnostics& diagnostics) {
    return std::shared_ptr<const orris::FileSource>(orris::openPack(pack, diagnostics));
  };
  request.load.dimension = world.environment.dimension;
  request.renderer = {.width = 160, .height = 90};
  request.camera = world.cameras.front();
  return request;
}

// The walls and the ground of any world are brighter than nothing.
bool showsSomething(const orris::Image8& picture) {
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (picture.at(x, y)[0] > 32 || picture.at(x, y)[1] > 32) return true;
    }
  }
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: host PACK WORLD\n";
    return 2;
  }
  orris::Diagnostics diagnostics;
  const auto context = orris::gl::createContext({}, diagnostics);
  const auto world = orris::loadWorld(argv[2], 0, diagnostics);
  if (!context || !world) {
    print(diagnostics);
    return 1;
  }
  const auto session =
      orris::RenderSession::create(*context, requestFor(argv[1], *world), *world, diagnostics);
  if (session) session->renderFrame(diagnostics);
  print(diagnostics);
  if (!session || !showsSomething(session->renderer().screenshot())) {
    std::cerr << "host: no picture\n";
    return 1;
  }
  std::cout << "host: drew " << argv[2] << " with " << argv[1] << '\n';
  return 0;
}
