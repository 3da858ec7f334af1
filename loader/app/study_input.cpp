#include "app/study_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/inputs.h"

namespace orris {
namespace {

/// Adds to the report; false and exit status 2 when there is an error among them.
bool take(Diagnostics& diagnostics, Report& report, int& status) {
  const bool good = !hasErrors(diagnostics);
  report.add(diagnostics);
  if (!good) status = kUsage;
  return good;
}

std::optional<PublishedMark> parseMark(const std::string& text, const ShaderPack& pack,
                                       Diagnostics& diagnostics) {
  const std::size_t colon = text.rfind(':');
  PublishedMark mark;
  if (colon != std::string::npos) {
    double ratio = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, ratio);
    if (error != std::errc() || stop != end || !(ratio > 0)) {
      Diagnostic& diagnostic = diagnostics.emplace_back();
      diagnostic.id = "mark-syntax";
      diagnostic.message = fmt::format("--mark {}: no cost ratio after the colon", text);
      diagnostic.hint = "write --mark NAME=VALUE,...:1.25";
      return std::nullopt;
    }
    mark.ratio = ratio;
  }
  auto setting = parseSetting(text.substr(0, colon), pack, {}, diagnostics);
  if (!setting) return std::nullopt;
  mark.setting = std::move(*setting);
  return mark;
}

/// Each size that occurs in the settings.
std::vector<ImageSize> sizesOf(const std::vector<Setting>& settings) {
  std::vector<ImageSize> sizes;
  for (const Setting& setting : settings)
    if (std::find(sizes.begin(), sizes.end(), setting.size) == sizes.end())
      sizes.push_back(setting.size);
  return sizes;
}

bool readReferenceFiles(const StudyOptions& options, StudyInput& study, Report& report,
                        int& status) {
  Diagnostics diagnostics;
  for (const std::string& path : options.references) {
    auto reference = readReference(path, diagnostics);
    if (!reference) continue;
    const ImageSize size{reference->mean.width, reference->mean.height};
    study.references[size] = std::move(*reference);
  }
  if (!take(diagnostics, report, status)) return false;
  for (const ImageSize size : sizesOf(study.settings)) {
    if (study.references.contains(size)) continue;
    report.error(
        "reference-size",
        fmt::format("no --reference is {}x{} pixels large", size.width, size.height),
        fmt::format("orris trace WORLD -o truth.exr --size {}x{}", size.width, size.height));
    status = kUsage;
  }
  return status == kClean;
}

bool readReferences(const StudyOptions& options, StudyInput& input, Report& report, int& status) {
  if (options.references.empty()) {
    report.error("reference-missing", "no --reference to measure errors against",
                 "give a picture of orris trace, or a setting: --reference NAME=VALUE,...");
    status = kUsage;
    return false;
  }
  const std::string& first = options.references.front();
  const bool isSetting = options.references.size() == 1 && !std::filesystem::exists(first) &&
                         first.find('=') != std::string::npos;
  if (!isSetting) return readReferenceFiles(options, input, report, status);
  Diagnostics diagnostics;
  input.reference = parseSetting(first, *input.pack, {}, diagnostics);
  return take(diagnostics, report, status);
}

/// Brings the first setting that --baseline names to the front.
void chooseBaseline(const std::string& text, StudyInput& study, Diagnostics& diagnostics) {
  const auto named = parseSetting(text, *study.pack, {}, diagnostics);
  if (!named) return;
  auto& settings = study.settings;
  const auto found = std::find_if(settings.begin(), settings.end(), [&](const Setting& setting) {
    return includes(setting, *named);
  });
  if (found != settings.end()) {
    std::rotate(settings.begin(), found, found + 1);
    return;
  }
  Diagnostic& diagnostic = diagnostics.emplace_back();
  diagnostic.id = "baseline-unknown";
  diagnostic.message = fmt::format("--baseline {}: none of the settings is that", text);
  diagnostic.hint = "name values of the axes";
}

bool readSettings(const StudyOptions& options, StudyInput& study, Report& report, int& status) {
  Diagnostics diagnostics;
  std::vector<Axis> axes;
  for (const std::string& text : options.axes) axes.push_back(parseAxis(text));
  const bool good = resolveAxes(axes, *study.pack, diagnostics);
  const ImageSize size{options.image.width, options.image.height};
  if (auto settings = good ? combine(axes, size, diagnostics) : std::nullopt)
    study.settings = std::move(*settings);
  if (!options.baseline.empty() && !study.settings.empty())
    chooseBaseline(options.baseline, study, diagnostics);
  for (const std::string& text : options.marks)
    if (auto mark = parseMark(text, *study.pack, diagnostics))
      study.marks.push_back(std::move(*mark));
  return take(diagnostics, report, status);
}

}  // namespace

std::optional<StudyInput> readStudyInput(const StudyOptions& options, Report& report, int& status) {
  auto world = loadScene(options.scene, options.pack.dimension, report, status);
  if (!world) return std::nullopt;
  const auto files = openPackFiles(options.pack.path, report, status);
  if (!files) return std::nullopt;
  PackOptions packOptions = options.pack;
  if (packOptions.dimension.empty()) packOptions.dimension = world->environment.dimension;
  const auto load = makeLoadRequest(files, packOptions, standardMacros({}), report, status);
  if (!load) return std::nullopt;
  LoadRequest optionsOnly = *load;
  optionsOnly.buildSources = false;
  auto pack = loadPack(files, optionsOnly, report, status);
  const auto camera =
      pack ? chooseCamera(*world, options.scene.camera, report, status) : std::nullopt;
  if (!camera) return std::nullopt;

  StudyInput input;
  input.world = std::move(*world);
  input.files = files;
  input.pack = std::make_shared<const ShaderPack>(std::move(*pack));
  input.request.openPack = [files](Diagnostics&) { return files; };
  input.request.load = *load;
  input.request.camera = *camera;
  input.request.seed = options.scene.seed;
  if (!readSettings(options, input, report, status)) return std::nullopt;
  if (!readReferences(options, input, report, status)) return std::nullopt;
  return input;
}

SessionRequest requestFor(const SessionRequest& base, const Setting& setting) {
  SessionRequest request = base;
  request.load = withSetting(base.load, setting);
  request.renderer.width = setting.size.width;
  request.renderer.height = setting.size.height;
  return request;
}

}  // namespace orris
