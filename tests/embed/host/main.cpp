// A host of its own around the library: its context, its world, its pixels, its report. It shows the
// least that a program needs to check a shader pack and to draw blocks with it.
#include <iostream>
#include <memory>

#include <orris/core/files/file_source.h>
#include <orris/gl/context.h>
#include <orris/render/session/render_session.h>
#include <orris/report/report_format.h>
#include <orris/validate/validate_pack.h>
#include <orris/world/world.h>

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

// What `orris validate --format sarif` reports of the pack.
bool isClean(const std::string& pack) {
  orris::ValidateOptions options;
  options.pack.path = pack;
  const orris::ValidateResult result = orris::validatePack(options);
  const std::string sarif = orris::writeSarif(result);
  std::cout << "host: " << result.packs[0].findings.size() << " findings, " << sarif.size()
            << " bytes of SARIF\n";
  return result.status == 0 && sarif.find("\"version\": \"2.1.0\"") != std::string::npos;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: host PACK WORLD\n";
    return 2;
  }
  if (!isClean(argv[1])) return 1;
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
