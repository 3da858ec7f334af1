#include "check/pack_checks.h"

#include <array>

#include "check/frame_checks.h"

namespace orris {
namespace {

using FolderCheck = void (*)(const FolderInput&, Diagnostics&);
using WholePackCheck = void (*)(std::span<const ShaderPack>, Diagnostics&);

// In the order of the report.
constexpr FolderCheck kFolderChecks[] = {checkTargetsRead, checkTargetsWritten};
constexpr std::array<WholePackCheck, 0> kWholePackChecks{};

}  // namespace

Diagnostics checkFolder(const FolderInput& input) {
  Diagnostics diagnostics;
  for (const FolderCheck check : kFolderChecks) check(input, diagnostics);
  return diagnostics;
}

Diagnostics checkWholePack(std::span<const ShaderPack> folders) {
  Diagnostics diagnostics;
  for (const WholePackCheck check : kWholePackChecks) check(folders, diagnostics);
  return diagnostics;
}

}  // namespace orris
