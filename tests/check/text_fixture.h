// Texts of small packs, and those of files.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/memory_pack.h"

namespace orris {

using Lines = std::vector<std::string>;

inline const std::string kVersion = "#version 330 compatibility\n";

inline const std::string kVertexStage = kVersion + "void main() { gl_Position = ftransform(); }\n";

inline std::string textOf(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace orris
