// How much the settled face cache changes over frames, of worlds of ours; for docs/results/global-illumination.md.
//   bench_face_boiling WORLD FRAMES_BEFORE FRAMES STEP [OPTION=VALUE...]
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "../shaderpack/face_boiling.h"

namespace orris::test {
namespace {

void measure(const std::string& world, int before, int frames, int step,
             const OptionValues& options) {
  PackSession pack = PackSession::ofWorld(world, options, 8, 8);
  if (testing::UnitTest::GetInstance()->ad_hoc_test_result().Failed()) std::exit(1);
  const BlockWorld& blocks = pack.session().scene().world.blocks;
  FaceBoiling boiling(blocks.origin(), blocks.size());
  const int volume = std::stoi(options.at("VOXEL_SIZE"));
  pack.renderFrames(before);
  for (int i = 0; i < frames; ++i) {
    pack.renderFrames(step);
    boiling.add(faceField(pack, volume));
  }
  fmt::print("{}: over the mean of the cache {:.4f}, of each face {:.4f}, {} lit faces\n", world,
             boiling.overMean(), boiling.ofFaces(), boiling.faces());
}

}  // namespace
}  // namespace orris::test

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);  // of the checks in the session
  if (argc < 5) return fmt::print("WORLD FRAMES_BEFORE FRAMES STEP [OPTION=VALUE...]\n"), 2;
  orris::OptionValues options{{"GI_METHOD", "FACE_CACHE"}, {"VOXEL_SIZE", "64"}};
  for (int i = 5; i < argc; ++i) {
    const std::string text = argv[i];
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) return fmt::print("{}: no OPTION=VALUE\n", text), 2;
    options[text.substr(0, equals)] = text.substr(equals + 1);
  }
  orris::test::measure(argv[1], std::atoi(argv[2]), std::atoi(argv[3]), std::atoi(argv[4]),
                       options);
}
