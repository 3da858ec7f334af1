#include "app/gallery/gallery_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "app/input/inputs.h"
#include "app/input/shipped_worlds.h"
#include <orris/check/workers/diagnostic_codec.h>
#include <orris/check/workers/isolated_jobs.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/read_places.h>
#include <orris/pack/files/text.h>
#include <orris/validate/driver_check.h>
#include <orris/world/random_room.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProfileNames = "profiles";  // id of a note that carries them

/// The text of a set, and where its own worlds lie.
struct SetText {
  std::string text, file;
  std::string folder;  ///< "": it has none
  int mistake = kUsage;  ///< exit status
};

std::optional<SetText> tooLarge(const std::string& file, Report& report, int& status) {
  report.error("gallery-set", fmt::format("is larger than {} bytes", kGallerySetBytes), "", file);
  status = kUsage;
  return std::nullopt;
}

std::optional<SetText> readSetFile(const std::string& path, Report& report, int& status) {
  auto text = readWholeFile(path, report);
  if (!text) {
    status = kUsage;
    return std::nullopt;
  }
  if (text->size() > kGallerySetBytes) return tooLarge(path, report, status);
  const fs::path folder = fs::path(path).parent_path();
  return SetText{std::move(*text), path, folder.empty() ? "." : folder.string(), kUsage};
}

/// --set-file, else gallery.json beside the pack's shaders folder, else the default.
std::optional<SetText> findSet(const GalleryOptions& options, const FileSource& files, Report& report,
                               int& status) {
  if (!options.setFile.empty()) return readSetFile(options.setFile, report, status);
  auto text = files.readResource(fmt::format("/../{}", kGallerySetFile));
  if (!text) return SetText{kDefaultGallerySet, "default", "", kUsage};
  const std::string name = (fs::path(options.pack.path) / kGallerySetFile).string();
  if (text->size() > kGallerySetBytes) return tooLarge(name, report, status);
  std::error_code error;
  const bool folder = fs::is_directory(options.pack.path, error);
  return SetText{std::move(*text), name, folder ? options.pack.path : "", kProblems};
}

/// The names of a pack's profiles; what the load reports comes again with the first picture. A worker reads
/// them: the pack is a stranger's.
std::vector<std::string> profileNames(const std::shared_ptr<const FileSource>& files, const PackOptions& pack) {
  std::vector<std::string> names;
  IsolatedJobs jobs;
  jobs.count = 1;
  jobs.work = [&](std::size_t) {
    Diagnostics ignored, result;
    LoadRequest request{.environment = standardMacros({.versions = pack.versions})};
    request.buildSources = false;
    const auto loaded = loadShaderPack(files, request, ignored);
    Diagnostic& note = result.emplace_back();
    note.severity = Severity::Note;
    note.id = kProfileNames;
    if (loaded)
      for (const Profile& profile : loaded->properties.profiles) note.notes.push_back(profile.name);
    return encodeDiagnostics(result);
  };
  runIsolated(jobs, [&](std::size_t, const JobOutcome& outcome) {
    if (outcome.kind != JobOutcome::Kind::Done) return true;
    for (const Diagnostic& diagnostic : decodeDiagnostics(outcome.result)) names = diagnostic.notes;
    return true;
  });
  return names;
}

/// The world that a set names: one that lies in the set's folder, that comes with Orris, or a random room.
/// "": there is no such world.
std::string findWorldOfSet(const std::string& name, const std::string& folder) {
  if (name.starts_with(kRandomRoom)) return randomRoomSeed(name) ? name : "";
  std::error_code error;
  const std::string own = folder.empty() ? "" : (fs::path(folder) / name).string();
  if (!own.empty() && !name.empty() && fs::exists(own, error) && liesBelow(folder, own)) return own;
  const std::vector<std::string> shipped = shippedWorldNames();
  return std::ranges::find(shipped, name) == shipped.end() ? "" : findWorld(name);
}

bool findWorlds(const SetText& text, GalleryInput& input, Diagnostics& diagnostics) {
  for (const GalleryShot& shot : input.set.shots) {
    input.worlds.push_back(findWorldOfSet(shot.world, text.folder));
    const std::string& path = input.worlds.back();
    if (!path.empty() && !path.starts_with(kRandomRoom)) addReadPlace(path);
    if (!path.empty()) continue;
    const std::string meant = suggest(shot.world, shippedWorldNames());
    diagnostics.push_back(JsonText{text.text, text.file}.error(
        shot.worldOffset, "gallery-set", fmt::format("there is no world \"{}\"", shot.world),
        meant.empty() ? "name a world in the folder of this file, one that comes with Orris, or random:SEED" : meant));
  }
  removeDuplicates(diagnostics);
  return diagnostics.empty();
}

bool knowsProfiles(const std::vector<std::string>& asked, const std::vector<std::string>& known, Report& report) {
  bool good = true;
  for (const std::string& name : asked) {
    if (name == "all" || std::ranges::find(known, name) != known.end()) continue;
    report.error("profile-unknown", fmt::format("--profiles: the pack has no profile {}", name), suggest(name, known));
    good = false;
  }
  return good;
}

bool readSet(const GalleryOptions& options, GalleryInput& input, Report& report, int& status) {
  const auto text = findSet(options, *input.files, report, status);
  if (!text) return false;
  Diagnostics diagnostics;
  const std::vector<std::string> known = profileNames(input.files, options.pack);
  if (!knowsProfiles(options.profiles, known, report)) status = kUsage;
  if (status != kClean) return false;
  auto set = parseGallerySet({text->text, text->file}, options.profiles, known, diagnostics);
  if (set) input.set = std::move(*set);
  const bool good = set && findWorlds(*text, input, diagnostics);
  report.add(diagnostics);
  if (!good) status = text->mistake;
  return good;
}

void chooseSize(const GalleryOptions& options, GalleryInput& input) {
  const ImageSize asked{options.image.width, options.image.height};
  input.size = options.sizeGiven ? asked : input.set.size.value_or(asked);
  input.frames = options.framesGiven ? options.image.frames : input.set.frames.value_or(options.image.frames);
}

}  // namespace

std::optional<GalleryInput> readGalleryInput(const GalleryOptions& options, Report& report,
                                             int& status) {
  GalleryInput input;
  if (!options.against.empty()) {
    input.filesBefore = openPackFiles(options.against, report);
    if (!input.filesBefore) status = kUsage;
    if (!input.filesBefore) return std::nullopt;
  }
  input.files = openPackFiles(options.pack.path, report);
  if (!input.files) status = kUsage;
  if (!input.files || !readSet(options, input, report, status)) return std::nullopt;
  chooseSize(options, input);
  if (!options.pack.settingsFile.empty()) addReadPlace(options.pack.settingsFile);
  Diagnostics diagnostics;
  auto driver = askDriver(options.image.backend, diagnostics);
  report.add(diagnostics);
  if (!driver) status = kHostFailed;
  if (!driver) return std::nullopt;
  input.driver = std::move(*driver);
  return input;
}

}  // namespace orris
