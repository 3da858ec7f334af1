#include "app/view/live_pack.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include "app/input/inputs.h"
#include "core/read_file.h"
#include "core/replace_file.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

fs::path withoutEndSlash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

// A pack's own option file lies beside it and is named like it.
std::string optionFileOf(const PackOptions& options) {
  if (!options.settingsFile.empty()) return options.settingsFile;
  return withoutEndSlash(options.path).string() + ".txt";
}

}  // namespace

LivePack::LivePack(const PackOptions& options, gl::Context& context, Report& report)
    : options_(options), context_(context), report_(report), optionFile_(optionFileOf(options)) {}

bool LivePack::open(const SceneOptions& scene, const ImageOptions& image, World world,
                    const Camera& camera) {
  const auto load = readChoices(true);
  if (!load) return false;
  SessionRequest request;
  request.openPack = [path = options_.path](Diagnostics& diagnostics) {
    return std::shared_ptr<const FileSource>(openPack(path, diagnostics));
  };
  request.load = *load;
  request.versions = options_.versions;
  if (options_.dimension.empty()) request.load.dimension = world.environment.dimension;
  request.renderer = {.width = image.width, .height = image.height};
  request.camera = camera;
  request.seed = scene.seed;
  Diagnostics diagnostics;
  session_ = RenderSession::create(context_, std::move(request), std::move(world), diagnostics);
  report_.add(diagnostics);
  return session_ != nullptr;
}

// The command line's choices with those of the option file as it is now; a pack need not have one.
std::optional<LoadRequest> LivePack::readChoices(bool withOptionFile) {
  PackOptions pack = options_;
  // Beside a pack lies what came with it: a link there may not lead out of the folder.
  const fs::path folder = fs::absolute(optionFile_).parent_path();
  const bool wanted =
      withOptionFile && (!pack.settingsFile.empty() || liesBelow(folder, optionFile_));
  pack.settingsFile = wanted ? optionFile_ : "";
  const auto files = openPackFiles(pack.path, report_);
  if (!files) return std::nullopt;
  const MacroDefinitions environment = environmentFor(context_.driver(), options_.versions);
  auto request = makeLoadRequest(files, pack, environment, report_);
  if (request) request->name = withoutEndSlash(pack.path).filename().string();
  return request;
}

/// Runs `change`, which says whether it succeeded, and notes what came of it.
template <class Change>
bool LivePack::attempt(const std::string& cause, const Change& change) {
  report_.beginAgain();
  const auto began = std::chrono::steady_clock::now();
  const std::size_t before = session_->reloads().size();
  Diagnostics diagnostics;
  outcome_ = {.cause = cause};
  outcome_.succeeded = change(diagnostics);
  outcome_.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  if (session_->reloads().size() > before) outcome_.report = session_->reloads().back().report;
  for (const Diagnostic& one : diagnostics)
    if (one.severity != Severity::Note) outcome_.problems.push_back(one);
  report_.add(diagnostics);
  return outcome_.succeeded;
}

bool LivePack::reload(const std::string& cause, bool withOptionFile) {
  return attempt(cause, [&](Diagnostics& diagnostics) {
    const std::size_t reported = report_.all().size();
    const auto choices = readChoices(withOptionFile);
    if (!choices) {
      diagnostics.assign(
          report_.all().begin() + std::ptrdiff_t(std::min(reported, report_.all().size())),
          report_.all().end());
      return false;
    }
    LoadRequest& request = session_->loadRequest();
    const OptionValues before = std::exchange(request.fileValues, choices->fileValues);
    if (session_->reload(cause, diagnostics)) return true;
    request.fileValues = before;
    return false;
  });
}

bool LivePack::setProfile(const std::string& name) {
  LoadRequest& request = session_->loadRequest();
  const std::string before = std::exchange(request.profile, name);
  const OptionValues fileBefore = std::exchange(request.fileValues, {});
  const bool done = attempt("profile " + name, [&](Diagnostics& diagnostics) {
    return session_->setProfile(name, diagnostics);
  });
  if (!done) {
    request.profile = before;
    request.fileValues = fileBefore;
  }
  return done;
}

bool LivePack::nextProfile() {
  const ShaderPack& pack = session_->renderer().pack();
  const std::vector<Profile>& profiles = pack.properties.profiles;
  if (profiles.empty()) return false;
  const auto at = std::ranges::find(profiles, pack.currentProfile(), &Profile::name);
  const bool last = at == profiles.end() || at + 1 == profiles.end();
  return setProfile(last ? profiles.front().name : (at + 1)->name);
}

bool LivePack::choose(const std::string& cause, const OptionValues& values) {
  const bool done = attempt(cause, [&](Diagnostics& diagnostics) {
    return session_->setValues(cause, values, diagnostics);
  });
  if (done) save();
  return done;
}

bool LivePack::setOptions(const std::string& cause, const OptionValues& changes) {
  OptionValues values = this->values();
  for (const auto& [name, value] : changes) {
    if (value.empty()) {
      values.erase(name);
    } else {
      values[name] = value;
    }
  }
  return choose(cause, values);
}

bool LivePack::resetOptions() { return choose("all options reset", {}); }

bool LivePack::chooseProfile(const std::string& name) {
  const std::vector<Profile>& profiles = session_->asked().properties.profiles;
  const auto found = std::ranges::find(profiles, name, &Profile::name);
  return found != profiles.end() && setOptions("profile " + name, found->values);
}

void LivePack::save() {
  const ShaderPack& pack = session_->asked();
  if (replaceFile(optionFile_, writeOptionFile(pack.options, pack.values))) {
    Diagnostics unsaved{{.severity = Severity::Warning,
                         .id = "options-unsaved",
                         .at = {.file = optionFile_},
                         .message = "the options cannot be saved there",
                         .hint = "put the pack into a folder that may be written, or name an option "
                                 "file with --settings"}};
    outcome_.problems.push_back(unsaved.front());
    report_.add(unsaved);
    return;
  }
  saved_ = true;
}

}  // namespace orris
