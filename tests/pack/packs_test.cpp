// Every folder of tests/packs: its diagnostics, over all dimensions, are those of expected.txt.
// ORRIS_UPDATE=1 writes the files anew.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <orris/pack/shader_pack.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = fs::path(ORRIS_TEST_DIR) / "packs";

std::vector<std::string> caseNames() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    if (fs::is_directory(entry.path() / "shaders"))
      names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string readText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Diagnostics loadAllDimensions(const std::string& path) {
  Diagnostics diagnostics;
  const std::shared_ptr<const FileSource> source = openPack(path, diagnostics);
  if (!source) return diagnostics;
  LoadRequest request{.environment = standardMacros({}), .buildSources = false};
  const auto pack = loadShaderPack(source, request, diagnostics);
  if (!pack) return diagnostics;
  request.buildSources = true;
  for (const std::string& folder : pack->dimensions) {
    request.dimension = folder;
    loadShaderPack(source, request, diagnostics);
  }
  removeDuplicates(diagnostics);
  return diagnostics;
}

class Packs : public testing::TestWithParam<std::string> {};

TEST_P(Packs, give_the_expected_diagnostics) {
  const fs::path folder = kFolder / GetParam();
  std::string found;
  for (const Diagnostic& diagnostic : loadAllDimensions(folder.string())) {
    found += formatDiagnostic(diagnostic) + "\n";
  }
  const fs::path expected = folder / "expected.txt";
  if (std::getenv("ORRIS_UPDATE")) std::ofstream(expected, std::ios::binary) << found;
  EXPECT_EQ(found, readText(expected));
}

std::string testName(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cases, Packs, testing::ValuesIn(caseNames()), testName);

}  // namespace
}  // namespace orris
