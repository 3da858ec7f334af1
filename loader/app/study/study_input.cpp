#include "app/study/study_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include "app/input/inputs.h"

namespace orris {
namespace {

/// Adds to the report; false when there is an error among them.
bool takeSetting(Diagnostics& diagnostics, Report& report) {
  const bool good = !hasErrors(diagnostics);
  report.add(diagnostics);
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

/// "CAMERA=FILE", or a file for the only camera. nullopt: reported.
std::optional<std::pair<std::size_t, std::string>> splitReference(const std::string& text,
                                                                  const StudyInput& input,
                                                                  Report& report) {
  if (input.cameras.size() == 1) return std::pair(std::size_t{0}, text);
  const std::string name = text.substr(0, text.find('='));
  for (std::size_t i = 0; i < input.cameras.size() && name.size() < text.size(); ++i)
    if (input.cameras[i].name == name) return std::pair(i, text.substr(name.size() + 1));
  report.error("reference-camera",
               fmt::format("--reference {}: which of the cameras is this of?", text),
               "write --reference CAMERA=FILE for each");
  return std::nullopt;
}

/// Reports each view that has no reference; true: there is none.
bool hasAllReferences(const StudyInput& input, Report& report) {
  bool all = true;
  for (std::size_t camera = 0; camera < input.cameras.size(); ++camera) {
    for (const ImageSize size : sizesOf(input.settings)) {
      if (input.references.contains({camera, size})) continue;
      report.error("reference-size",
                   fmt::format("no --reference is {}x{} pixels large, from camera {}", size.width,
                               size.height, input.cameras[camera].name),
                   fmt::format("orris trace WORLD -o reference.exr --size {}x{} --camera {}",
                               size.width, size.height, input.cameras[camera].name));
      all = false;
    }
  }
  return all;
}

bool readReferenceFiles(const StudyOptions& options, StudyInput& input, Report& report) {
  Diagnostics diagnostics;
  for (const std::string& text : options.references) {
    const auto named = splitReference(text, input, report);
    if (!named) return false;
    auto reference = readReference(named->second, diagnostics);
    if (!reference) continue;
    const ImageSize size{reference->mean.width, reference->mean.height};
    input.references[{named->first, size}] = std::move(*reference);
  }
  return takeSetting(diagnostics, report) && hasAllReferences(input, report);
}

/// Is it a setting, and not CAMERA=FILE or a file?
bool isSetting(const std::string& text, const StudyInput& input) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || std::filesystem::exists(text)) return false;
  const std::string name = text.substr(0, equals);
  return input.cameras.size() == 1 || input.world.camera(name) == nullptr;
}

bool readReferences(const StudyOptions& options, StudyInput& input, Report& report) {
  if (options.references.empty()) {
    report.error("reference-missing", "no --reference to measure errors against",
                 "give a picture of orris trace, or a setting: --reference NAME=VALUE,...");
    return false;
  }
  const std::string& first = options.references.front();
  if (options.references.size() > 1 || !isSetting(first, input))
    return readReferenceFiles(options, input, report);
  Diagnostics diagnostics;
  input.reference = parseSetting(first, *input.pack, {}, diagnostics);
  return takeSetting(diagnostics, report);
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

bool readStudySettings(const StudyOptions& options, StudyInput& study, Report& report) {
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
  return takeSetting(diagnostics, report);
}

bool readCameras(const StudyOptions& options, StudyInput& input, Report& report) {
  std::vector<std::string> names;
  for (const std::string& name : options.cameras)
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  const char* flag = names.empty() ? "--camera" : "--cameras";
  if (names.empty()) names = {options.scene.camera};
  if (names == std::vector<std::string>{"all"}) {
    input.cameras = input.world.cameras;
    return true;
  }
  for (const std::string& name : names)
    if (const auto camera = chooseCamera(input.world, name, report, flag))
      input.cameras.push_back(*camera);
  return input.cameras.size() == names.size();
}

}  // namespace

std::optional<StudyInput> readStudyInput(const StudyOptions& options, Report& report) {
  auto world = loadScene(options.scene, options.pack.dimension, report);
  if (!world) return std::nullopt;
  const auto files = openPackFiles(options.pack.path, report);
  if (!files) return std::nullopt;
  PackOptions packOptions = options.pack;
  if (packOptions.dimension.empty()) packOptions.dimension = world->environment.dimension;
  const MacroDefinitions environment = standardMacros({.versions = options.pack.versions});
  const auto load = makeLoadRequest(files, packOptions, environment, report);
  if (!load) return std::nullopt;
  LoadRequest optionsOnly = *load;
  optionsOnly.buildSources = false;
  auto pack = loadPack(files, optionsOnly, report);
  if (!pack) return std::nullopt;

  StudyInput input;
  input.world = std::move(*world);
  input.files = files;
  input.pack = std::make_shared<const ShaderPack>(std::move(*pack));
  input.request.openPack = [files](Diagnostics&) { return files; };
  input.request.load = *load;
  input.request.versions = options.pack.versions;
  if (!readCameras(options, input, report)) return std::nullopt;
  input.request.camera = input.cameras.front();
  input.request.seed = options.scene.seed;
  if (!readStudySettings(options, input, report)) return std::nullopt;
  if (!readReferences(options, input, report)) return std::nullopt;
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
