#include "app/view/pack/live_pack.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include "app/input/inputs.h"
#include <orris/core/files/read_file.h>
#include <orris/core/files/replace_file.h>
#include <orris/pack/programs/folder_build.h>
#include <orris/pack/programs/live_check.h>
#include <orris/pack/rebuild.h>
#include <orris/report/problem_list.h>

namespace orris {
namespace {

namespace fs = std::filesystem;

fs::path withoutEndSlash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

/// The request for a pack as the command line and its option file, where one is named, have it now.
std::optional<LoadRequest> readChoices(const std::shared_ptr<const FileSource>& files,
                                       const PackOptions& options, const MacroDefinitions& environment,
                                       Diagnostics& diagnostics) {
  auto request = makeLoadRequest(files, options, environment, diagnostics);
  if (request) request->name = withoutEndSlash(options.path).filename().string();
  return request;
}

std::shared_ptr<const ShaderPack> shared(std::optional<ShaderPack> pack) {
  return pack ? std::make_shared<const ShaderPack>(std::move(*pack)) : nullptr;
}

}  // namespace

std::string optionFileOf(const PackOptions& options) {
  if (!options.settingsFile.empty()) return options.settingsFile;
  return withoutEndSlash(options.path).string() + ".txt";
}

LivePack::LivePack(const PackOptions& options, gl::Context& context, Report& report)
    : options_(options), context_(context), report_(report), optionFile_(optionFileOf(options)) {}

bool LivePack::open(const SceneOptions& scene, const ImageOptions& image, World world,
                    const Camera& camera, const std::optional<KeptState>& kept) {
  const auto files = kept ? openKept(*kept) : openPackFiles(options_.path, report_);
  if (!files) return false;
  Diagnostics diagnostics;
  PackOptions options = optionsNow();
  if (kept) {
    options.values.clear();
    options.profile.clear();
    options.settingsFile.clear();
  }
  auto load = readChoices(files, options, environmentFor(context_.driver(), options_.versions), diagnostics);
  report_.add(diagnostics);
  if (!load) return false;
  if (kept) load->fileValues = kept->values;
  SessionRequest request;
  // Later loads are readingAgain().
  request.openPack = [files](Diagnostics&) { return files; };
  request.load = *load;
  request.versions = options_.versions;
  if (options_.dimension.empty()) request.load.dimension = world.environment.dimension;
  request.renderer = {.width = image.width, .height = image.height};
  request.camera = camera;
  request.seed = scene.seed;
  session_ = RenderSession::create(context_, std::move(request), std::move(world), diagnostics);
  report_.add(diagnostics);
  return session_ != nullptr;
}

std::shared_ptr<const FileSource> LivePack::openKept(const KeptState& kept) {
  report_.setPack(options_.path);
  Diagnostics ignored;  // of files as they are now
  std::shared_ptr<const FileSource> now = openPack(options_.path, ignored);
  return keptFiles(kept, now ? std::move(now) : memorySource({}));
}

void LivePack::noteDeath(const Diagnostic& cause) {
  outcome_ = {.cause = "the driver died", .succeeded = false, .problems = {cause}};
}

// The command line's choices with the option file; a pack need not have one.
PackOptions LivePack::optionsNow() const {
  PackOptions pack = options_;
  // Beside a pack lies what came with it: a link there may not lead out of the folder.
  const fs::path folder = fs::absolute(optionFile_).parent_path();
  const bool wanted = !pack.settingsFile.empty() || liesBelow(folder, optionFile_);
  pack.settingsFile = wanted ? optionFile_ : "";
  return pack;
}

PackLoader LivePack::readingAgain(bool withOptionFile) const {
  PackOptions options = optionsNow();
  if (!withOptionFile) options.settingsFile.clear();
  return [options, environment = environmentFor(context_.driver(), options_.versions),
          asked = session_->sharedAsked()](
             LoadRequest& request, Diagnostics& diagnostics) -> std::shared_ptr<const ShaderPack> {
    const std::shared_ptr<const FileSource> files = openPack(options.path, diagnostics);
    if (!files) return nullptr;
    const auto choices = readChoices(files, options, environment, diagnostics);
    if (!choices) return nullptr;
    request.fileValues = choices->fileValues;
    request.live.clear();
    return shared(loadShaderPack(files, request, {.earlier = asked.get()}, diagnostics));
  };
}

PackLoader LivePack::withValues(const OptionValues& values) const {
  return [values, asked = session_->sharedAsked()](LoadRequest& request, Diagnostics& diagnostics) {
    // What an #if asks for may be another under other values.
    for (const std::string& name : differingOptions(asked->options, values, asked->values))
      if (!request.live.contains(name)) request.live = {};
    request.fileValues = values;
    request.profile.clear();
    request.values.clear();
    return shared(rebuildShaderPack(*asked, request, diagnostics));
  };
}

PackLoader LivePack::withLive(const std::set<std::string>& names) const {
  return [names, asked = session_->sharedAsked()](LoadRequest& request, Diagnostics& diagnostics) {
    request.live = names;
    return shared(rebuildShaderPack(*asked, request, diagnostics));
  };
}

void LivePack::reload(const std::string& cause, bool withOptionFile) {
  // One that has not begun will read the same files.
  for (std::size_t i = 1; i < attempts_.size(); ++i)
    if (attempts_[i].cause == cause) return;
  attempts_.push_back({cause, [=, this] { return readingAgain(withOptionFile); }});
}

void LivePack::setProfile(const std::string& name) {
  attempts_.push_back({"profile " + name, [this, name]() -> PackLoader {
    return [name, asked = session_->sharedAsked()](LoadRequest& request, Diagnostics& diagnostics) {
      request.profile = name;
      request.fileValues.clear();
      request.live.clear();
      return shared(rebuildShaderPack(*asked, request, diagnostics));
    };
  }});
}

void LivePack::nextProfile() {
  const ShaderPack& pack = session_->renderer().pack();
  const std::vector<Profile>& profiles = pack.properties.profiles;
  if (profiles.empty()) return;
  const auto at = std::ranges::find(profiles, pack.currentProfile(), &Profile::name);
  const bool last = at == profiles.end() || at + 1 == profiles.end();
  setProfile(last ? profiles.front().name : (at + 1)->name);
}

void LivePack::setOptions(const std::string& cause, const OptionValues& changes) {
  const auto loader = [this, changes] {
    OptionValues values = this->values();
    for (const auto& [name, value] : changes) {
      if (value.empty()) {
        values.erase(name);
      } else {
        values[name] = value;
      }
    }
    return withValues(values);
  };
  attempts_.push_back({.cause = cause, .loader = loader, .saves = true});
}

void LivePack::chooseValues(const std::string& cause, const OptionValues& values) {
  attempts_.push_back(
      {.cause = cause, .loader = [this, values] { return withValues(values); }, .saves = true});
}

void LivePack::chooseProfile(const std::string& name) {
  const std::vector<Profile>& profiles = session_->asked().properties.profiles;
  const auto found = std::ranges::find(profiles, name, &Profile::name);
  if (found != profiles.end()) setOptions("profile " + name, found->values);
}

void LivePack::setLive(const std::set<std::string>& names) {
  attempts_.push_back({.cause = fmt::format("live: {}", fmt::join(names, " ")),
                       .loader = [this, names] { return withLive(names); }});
}

void LivePack::drag(const std::string& name, const std::string& value) {
  dragged_[name] = value;
  if (session_->asked().live.contains(name)) return session_->renderer().setLive(name, value);
  const auto waits = [&](const Attempt& one) { return one.drags == name; };
  if (std::ranges::any_of(attempts_, waits)) return;
  const auto loader = [this, name] {
    std::set<std::string> names = session_->asked().live;
    names.insert(name);
    return withLive(names);
  };
  attempts_.push_back({.cause = name + " live", .loader = loader, .drags = name});
}

const std::map<std::string, std::string>* LivePack::liveReasons(bool wait) {
  const auto& asked = session_->sharedAsked();
  const auto ready = [&] {
    return wait || live_.coming.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
  };
  if (live_.coming.valid() && ready()) live_.reasons = live_.coming.get();
  if (live_.coming.valid()) return nullptr;
  if (live_.pack == asked) return &live_.reasons;
  live_.pack = asked;
  live_.coming = std::async(std::launch::async, [asked] { return liveOptions(*asked); });
  return wait ? liveReasons(true) : nullptr;
}

std::string LivePack::doing() const { return attempts_.empty() ? "" : attempts_.front().cause; }

void LivePack::begin() {
  Attempt& first = attempts_.front();
  first.begun = Clock::now();
  loadsBefore_ = session_->reloads().size();
  session_->begin(first.cause, first.loader());
}

bool LivePack::advance(double seconds, double passed) {
  if (attempts_.empty()) return false;
  Attempt& first = attempts_.front();
  if (first.begun == Clock::time_point()) {
    begin();
  } else {
    ++first.frames;
    first.longestFrame = std::max(first.longestFrame, passed);
  }
  Diagnostics diagnostics;
  const auto succeeded = session_->advance(seconds, diagnostics);
  return end(succeeded, std::move(diagnostics));
}

bool LivePack::finish() {
  if (attempts_.empty()) return false;
  if (attempts_.front().begun == Clock::time_point()) begin();
  Diagnostics diagnostics;
  const auto succeeded = session_->finish(diagnostics);
  return end(succeeded, std::move(diagnostics));
}

/// Notes what came of the attempt that was in progress.
bool LivePack::end(std::optional<bool> succeeded, Diagnostics diagnostics) {
  if (!succeeded) return false;
  const Attempt attempt = std::move(attempts_.front());
  attempts_.pop_front();
  if (!*succeeded && !attempt.drags.empty()) {
    // No mistake of the pack: the option is built like any other when it is let go.
    live_.reasons[attempt.drags] = "its programs cannot be built with a uniform";
    dragged_.erase(attempt.drags);
    return false;
  }
  outcome_ = {.cause = attempt.cause, .succeeded = *succeeded, .frames = attempt.frames,
              .longestFrame = attempt.longestFrame};
  outcome_.seconds = std::chrono::duration<double>(Clock::now() - attempt.begun).count();
  if (session_->reloads().size() > loadsBefore_) outcome_.report = session_->reloads().back().report;
  // A mistake in a file that many programs include is one problem.
  ProblemList problems;
  Diagnostics found = diagnostics;
  problems.add(found);
  for (const Diagnostic& one : problems.all())
    if (one.severity != Severity::Note) outcome_.problems.push_back(one);
  report_.beginAgain();
  report_.add(diagnostics);
  if (*succeeded && attempt.saves) save();
  if (*succeeded && attempt.drags.empty()) dragged_.clear();
  for (const auto& [name, value] : dragged_) session_->renderer().setLive(name, value);
  return true;
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
