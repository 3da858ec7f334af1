// replay NAME PATH...: feeds files, or the files of folders, to a fuzz target: the corpus as an ordinary test.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "replay_targets.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> inputsOf(const fs::path& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(path)) {
    if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

void replay(FuzzTarget target, const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  // Named before it runs, so that a crash tells which input it was.
  std::printf("%s\n", path.c_str());
  std::fflush(stdout);
  target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
}

}  // namespace

int main(int argc, char** argv) {
  const FuzzTarget target = argc > 1 ? fuzzTarget(argv[1]) : nullptr;
  if (!target) {
    std::fprintf(stderr, "replay NAME PATH...: NAME is that of a *_fuzz.cpp\n");
    return 2;
  }
  int count = 0;
  for (int i = 2; i < argc; ++i) {
    for (const fs::path& path : inputsOf(argv[i])) {
      replay(target, path);
      ++count;
    }
  }
  std::printf("%d inputs\n", count);
  return count > 0 ? 0 : 1;
}
