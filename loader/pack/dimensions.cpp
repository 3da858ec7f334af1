#include "pack/dimensions.h"

#include <algorithm>
#include <array>

#include "core/pack_path.h"
#include "pack/program_id.h"
#include "pack/properties_text.h"
#include "pack/text.h"

namespace orris {
namespace {

constexpr const char* kFile = "/dimension.properties";

struct LegacyFolder {
  std::string_view folder, dimension;
};
constexpr std::array<LegacyFolder, 3> kLegacy{{{"/world0", "minecraft:overworld"},
                                               {"/world-1", "minecraft:the_nether"},
                                               {"/world1", "minecraft:the_end"}}};

std::string withNamespace(std::string_view dimension) {
  return (dimension.find(':') == std::string_view::npos ? "minecraft:" : "") +
         std::string(dimension);
}

bool hasPrograms(const FileSource& source, const std::string& folder) {
  return std::any_of(source.files().begin(), source.files().end(), [&](const std::string& path) {
    const auto program = parseProgramFile(path);
    return program && program->folder == folder;
  });
}

void addMapping(const PropertyEntry& entry, Dimensions& dimensions, Diagnostics& diagnostics) {
  constexpr std::string_view kPrefix = "dimension.";
  if (!entry.key.starts_with(kPrefix)) return;
  const auto folder = resolvePackPath(kFile, entry.key.substr(kPrefix.size()));
  if (!folder || *folder == "/") {
    diagnostics.push_back(propertyDiagnostic(Severity::Warning, "dimension-folder", entry,
                                             "the key names no folder inside shaders/"));
    return;
  }
  dimensions.folders.push_back(*folder);
  for (const std::string& word : splitBlanks(entry.value)) {
    if (word == "*") {
      dimensions.base = *folder;
    } else {
      dimensions.folderOf[withNamespace(word)] = *folder;
    }
  }
}

void addLegacy(const FileSource& source, Dimensions& dimensions) {
  for (const LegacyFolder& legacy : kLegacy) {
    const std::string folder(legacy.folder);
    const bool exists = std::any_of(source.files().begin(), source.files().end(),
                                    [&](auto& path) { return path.starts_with(folder + "/"); });
    if (!exists) continue;
    dimensions.folders.push_back(folder);
    dimensions.folderOf[std::string(legacy.dimension)] = folder;
    if (folder == "/world0") dimensions.base = folder;
  }
}

}  // namespace

std::string Dimensions::resolve(const std::string& dimension) const {
  const auto known = [&](const std::string& folder) {
    return std::find(folders.begin(), folders.end(), folder) != folders.end();
  };
  const std::string folder = dimension.starts_with('/') ? dimension : "/" + dimension;
  if (known(folder)) return folder;
  std::string id = withNamespace(dimension);
  for (const LegacyFolder& legacy : kLegacy) {
    if (legacy.folder == folder) id = legacy.dimension;
  }
  const auto found = folderOf.find(id);
  return found != folderOf.end() && known(found->second) ? found->second : base;
}

Dimensions readDimensions(const FileSource& source, const MacroDefinitions& environment,
                          Diagnostics& diagnostics) {
  Dimensions dimensions;
  if (const auto text = source.read(kFile)) {
    const std::string preprocessed = preprocessProperties(kFile, *text, environment, diagnostics);
    for (const auto& entry :
         lastValues(parseProperties(kFile, preprocessed, Continuation::Preprocessed, *text))) {
      addMapping(entry, dimensions, diagnostics);
    }
  }
  if (dimensions.folders.empty()) addLegacy(source, dimensions);
  dimensions.folders.insert(dimensions.folders.begin(), "/");
  std::erase_if(dimensions.folders, [&](auto& folder) { return !hasPrograms(source, folder); });
  const auto& folders = dimensions.folders;
  if (std::find(folders.begin(), folders.end(), dimensions.base) == folders.end())
    dimensions.base = "/";
  return dimensions;
}

}  // namespace orris
