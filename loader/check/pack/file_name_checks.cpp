#include <orris/check/pack/file_name_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include <orris/check/pack/pack_texts.h>
#include <orris/core/files/pack_path.h>
#include <orris/pack/files/text.h>
#include <orris/pack/programs/program_id.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 6> kEnds = {".vsh", ".fsh", ".gsh", ".csh", ".tcs", ".tes"};
constexpr std::array<std::string_view, 6> kNumberedGroups = {"setup",   "begin",    "shadowcomp",
                                                             "prepare", "deferred", "composite"};

bool isStageFile(std::string_view path) {
  return std::any_of(kEnds.begin(), kEnds.end(), [&](auto end) { return path.ends_with(end); });
}

/// "gbuffers_water" of "/world0/gbuffers_water.fsh".
std::string_view programName(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  return name.substr(0, name.find('.'));
}

// Colorwheel, Distant Horizons, Photonics, Voxy.
bool isOfMod(std::string_view name) {
  return name.starts_with("clrwl_") || name.starts_with("dh_") || name.starts_with("voxy") ||
         name.starts_with("photonics") || name.ends_with("_voxels");
}

std::vector<std::string> programNames() {
  std::vector<std::string> names{"final"};
  for (const std::string_view name : kNumberedGroups) names.emplace_back(name);
  for (const GeometryProgram& program : geometryPrograms()) names.emplace_back(program.name);
  return names;
}

/// The group whose numbers the name leaves, "" when it is not of that form.
std::string_view badlyNumbered(std::string_view name) {
  for (const std::string_view group : kNumberedGroups) {
    const std::string_view rest = name.starts_with(group) ? name.substr(group.size()) : "";
    if (!rest.empty() && rest.find_first_not_of("0123456789") == std::string_view::npos)
      return group;
  }
  return "";
}

/// "setup_a", "setup2_b"
bool isLetteredSetup(std::string_view name) {
  const std::string_view rest = name.starts_with("setup") ? name.substr(5) : "";
  const size_t letter = rest.find_first_not_of("0123456789");
  return letter != std::string_view::npos && rest.size() == letter + 2 && rest[letter] == '_';
}

class FileNames {
 public:
  FileNames(const ShaderPack& pack, Diagnostics& diagnostics)
      : pack_(pack), diagnostics_(diagnostics), names_(programNames()) {
    for (const auto& [file, lines] : pack.files) reached_.insert(file);
  }

  void check() {
    for (const std::string& path : pack_.source->files()) {
      if (!isStageFile(path) || isOfMod(programName(path))) continue;
      const std::string folder(packPathParent(path));
      if (!isProgramFolder(folder)) {
        checkFolder(path, folder);
      } else if (!parseProgramFile(path)) {
        if (!reached_.contains(path)) checkName(path);
      } else {
        checkAlone(path);
      }
    }
  }

 private:
  bool isProgramFolder(const std::string& folder) const {
    const auto& known = pack_.dimensions;
    return folder == "/" || std::find(known.begin(), known.end(), folder) != known.end();
  }

  void checkName(const std::string& path) {
    const std::string name(programName(path));
    if (const std::string_view group = badlyNumbered(name); !group.empty()) {
      return report(Severity::Warning, "program-file-unknown", path,
                    fmt::format("no program is called {}", name),
                    fmt::format("numbers go from {0}1 to {0}99, the first is {0}", group));
    }
    if (isLetteredSetup(name)) {
      return report(
          Severity::Warning, "program-file-unknown", path,
          fmt::format("Iris never runs {}: programs of setup have numbers, no letters", name),
          "name it setup1.csh to setup99.csh");
    }
    // A file that was renamed to take it out of use keeps its name within the new one.
    const bool renamed = std::any_of(names_.begin(), names_.end(), [&](const std::string& known) {
      return name.starts_with(known + "_");
    });
    const std::string meant = renamed ? "" : meantProgram(name);
    report(meant.empty() || isCopy(path, name, meant) ? Severity::Note : Severity::Warning,
           "program-file-unknown", path,
           fmt::format("no program is called {}", name),
           meant.empty() ? "" : fmt::format("did you mean {}?", meant));
  }

  /// "composite 3.vsh" beside composite3.vsh, which is what the host reads.
  bool isCopy(const std::string& path, std::string name, const std::string& meant) const {
    std::erase(name, ' ');
    const std::string folder(packPathParent(path));
    return name == meant &&
           pack_.source->contains((folder == "/" ? folder : folder + "/") + meant + path.substr(path.rfind('.')));
  }

  /// "composite3" for "compsite3".
  std::string meantProgram(const std::string& name) const {
    const size_t digits = name.find_last_not_of("0123456789") + 1;
    const std::string group = likelyMeant(name.substr(0, digits), names_);
    const bool numbered = std::ranges::find(kNumberedGroups, group) != std::end(kNumberedGroups);
    return numbered ? group + name.substr(digits) : likelyMeant(name, names_);
  }

  // Contract: README "Loading order" 6.
  void checkAlone(const std::string& path) {
    if (!path.ends_with(".vsh") || reached_.empty()) return;
    const std::string fragment = path.substr(0, path.size() - 3) + "fsh";
    if (pack_.source->contains(fragment)) return;
    report(Severity::Warning, "program-file-alone", path,
           fmt::format("without a {} no host makes a program of it",
                       fragment.substr(fragment.rfind('/') + 1)),
           "add the fragment stage, or delete this file");
  }

  // Programs in a folder that is nearly called like one of a dimension.
  void checkFolder(const std::string& path, const std::string& folder) {
    if (reached_.contains(path) || !parseProgramFile(path) || !folders_.insert(folder).second)
      return;
    const std::string name = lowerCase(folder.substr(1));
    // Dimensions of other mods, which OptiFine reads by number.
    if (folder.starts_with("/world") && parseInteger(folder.substr(6))) return;
    static const std::vector<std::string> kFolders = {"world0", "world-1", "world1"};
    std::string meant;
    for (const std::string& known : kFolders) {
      const bool sameLetters = name == known || name == "world_" + known.substr(5);
      if (sameLetters) meant = known;
    }
    if (meant.empty()) meant = likelyMeant(name, kFolders);
    if (meant.empty()) return;
    report(Severity::Warning, "program-folder-unknown", path,
           fmt::format("no dimension uses the programs of {}", folder),
           fmt::format("did you mean /{}? Other names need a line in dimension.properties", meant));
  }

  void report(Severity severity, const char* id, const std::string& path, std::string message,
              std::string hint) {
    diagnostics_.push_back({.severity = severity,
                            .id = id,
                            .at = {.file = path},
                            .message = std::move(message),
                            .hint = std::move(hint)});
  }

  const ShaderPack& pack_;
  Diagnostics& diagnostics_;
  std::vector<std::string> names_;
  std::set<std::string> reached_;
  std::set<std::string> folders_;
};

}  // namespace

void checkFileNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  if (folders.empty() || !folders.front().source) return;
  FileNames(folders.front(), diagnostics).check();
}

}  // namespace orris
