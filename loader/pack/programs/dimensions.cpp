#include <orris/pack/programs/dimensions.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include <orris/core/limits.h>
#include <orris/core/message_limits.h>
#include <orris/core/files/pack_path.h>
#include <orris/core/files/text_file.h>
#include <orris/pack/files/properties_text.h>
#include <orris/pack/files/text.h>
#include <orris/pack/programs/program_id.h>

namespace orris {
namespace {

constexpr const char* kDimensionFile = "/dimension.properties";
constexpr std::string_view kDimensionPrefix = "dimension.";

struct LegacyFolder {
  std::string_view folder, dimension;
};
constexpr std::array<LegacyFolder, 3> kLegacy{{{"/world0", "minecraft:overworld"},
                                               {"/world-1", "minecraft:the_nether"},
                                               {"/world1", "minecraft:the_end"}}};

std::set<std::string> foldersWithPrograms(const FileSource& source) {
  std::set<std::string> folders;
  for (const std::string& path : source.files()) {
    if (const auto program = parseProgramFile(path)) folders.insert(program->folder);
  }
  return folders;
}

bool isMapping(const PropertyEntry& entry) { return entry.key.starts_with(kDimensionPrefix); }

/// nullopt for a path out of the pack and for another key.
std::optional<std::string> folderOfKey(const PropertyEntry& entry) {
  return isMapping(entry)
             ? resolvePackPath(kDimensionFile, entry.key.substr(kDimensionPrefix.size()))
             : std::nullopt;
}

void addMapping(const PropertyEntry& entry, Dimensions& dimensions, Diagnostics& diagnostics) {
  if (!isMapping(entry)) return;
  const auto folder = folderOfKey(entry);
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

bool exists(const FileSource& source, const std::string& folder) {
  const auto& files = source.files();
  const auto first = std::lower_bound(files.begin(), files.end(), folder + "/");
  return first != files.end() && first->starts_with(folder + "/");
}

/// Names of the folders with programs that belong to no dimension.
std::vector<std::string> unusedFolders(const std::set<std::string>& withPrograms,
                                       const Dimensions& dimensions) {
  std::set<std::string> names;
  for (const std::string& folder : withPrograms) {
    if (folder != "/") names.insert(folder.substr(1));
  }
  for (const std::string& folder : dimensions.folders) names.erase(folder.substr(1));
  return {names.begin(), names.end()};
}

// Iris: ShaderPack.getProgramSet logs an error for a dimension whose folder is not there. Only "*"
// may lead nowhere: so a pack leaves the other dimensions alone.
void checkFolder(const FileSource& source, const PropertyEntry& entry,
                 const std::vector<std::string>& unused, Diagnostics& diagnostics) {
  const auto folder = folderOfKey(entry);
  if (!folder || *folder == "/" || exists(source, *folder) || trim(entry.value).empty()) return;
  const std::string name = folder->substr(1);
  const std::string hint = suggest(name, unused);
  const bool mayBeMeant = trim(entry.value) == "*" && hint.empty();
  diagnostics.push_back(propertyDiagnostic(
      mayBeMeant ? Severity::Note : Severity::Warning, "dimension-folder", entry,
      fmt::format("the pack has no folder {}, so {} has no programs of its own", name,
                  trim(entry.value) == "*" ? "any other dimension" : trim(entry.value)),
      hint));
}

void addLegacy(const FileSource& source, Dimensions& dimensions) {
  for (const LegacyFolder& legacy : kLegacy) {
    const std::string folder(legacy.folder);
    if (!exists(source, folder)) continue;
    dimensions.folders.push_back(folder);
    dimensions.folderOf[std::string(legacy.dimension)] = folder;
    if (folder == "/world0") dimensions.base = folder;
  }
}

/// The programs of each folder are built and checked.
void limitFolders(Dimensions& dimensions, Diagnostics& diagnostics) {
  auto& folders = dimensions.folders;
  if (folders.size() <= limits::kDimensionFolders) return;
  diagnostics.push_back(
      {.severity = Severity::Error,
       .id = "property-limit",
       .at = {.file = kDimensionFile},
       .message = fmt::format("{} folders have programs, more than {}; {} and those after it are "
                              "left out",
                              folders.size(), limits::kDimensionFolders,
                              folders[limits::kDimensionFolders].substr(1))});
  folders.resize(limits::kDimensionFolders);
}

// Iris: ShaderPack.getProgramSet; with a folder for every dimension the one above is left alone.
// OptiFine gives it to the dimensions that have no folder of their own.
bool isRootRead(const Dimensions& dimensions, const MacroDefinitions& environment) {
  const bool iris = std::any_of(environment.begin(), environment.end(),
                                [](const auto& macro) { return macro.first == "IS_IRIS"; });
  return dimensions.base == "/" || !iris;
}

void noteUnreadRoot(const Dimensions& dimensions, Diagnostics& diagnostics) {
  if (dimensions.rootIsRead || dimensions.folders.front() != "/") return;
  diagnostics.push_back(
      {.severity = Severity::Note,
       .id = "dimension-folder",
       .at = {.file = "/"},
       .message = fmt::format("no dimension gets the programs directly in shaders/: {} serves all "
                              "that have no folder of their own",
                              dimensions.base.substr(1)),
       .hint = "they are not checked; name them with --dimensions / to check them"});
}

}  // namespace

std::vector<std::string> Dimensions::readFolders() const {
  std::vector<std::string> read = folders;
  if (!rootIsRead) std::erase(read, "/");
  return read;
}

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
  const std::set<std::string> withPrograms = foldersWithPrograms(source);
  if (const auto text = readText(source, kDimensionFile, diagnostics)) {
    const std::string preprocessed =
        preprocessProperties(kDimensionFile, *text, environment, diagnostics);
    const auto entries = lastValues(
        parseProperties(kDimensionFile, preprocessed, Continuation::Preprocessed, *text));
    for (const auto& entry : entries) addMapping(entry, dimensions, diagnostics);
    const auto unused = unusedFolders(withPrograms, dimensions);
    for (const auto& entry : entries) checkFolder(source, entry, unused, diagnostics);
    boundMessages(diagnostics);
  }
  if (dimensions.folders.empty()) addLegacy(source, dimensions);
  dimensions.folders.insert(dimensions.folders.begin(), "/");
  std::erase_if(dimensions.folders, [&](auto& folder) { return !withPrograms.contains(folder); });
  limitFolders(dimensions, diagnostics);
  const auto& folders = dimensions.folders;
  if (std::find(folders.begin(), folders.end(), dimensions.base) == folders.end())
    dimensions.base = "/";
  dimensions.rootIsRead = isRootRead(dimensions, environment);
  noteUnreadRoot(dimensions, diagnostics);
  return dimensions;
}

}  // namespace orris
