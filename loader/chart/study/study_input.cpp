#include <orris/chart/study/study_input.h>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

#include <orris/core/add_diagnostic.h>

namespace orris {
namespace {

std::optional<PublishedMark> parseMark(const std::string& text, const ShaderPack& pack,
                                       Diagnostics& diagnostics) {
  const std::size_t colon = text.rfind(':');
  PublishedMark mark;
  if (colon != std::string::npos) {
    double ratio = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, ratio);
    if (error != std::errc() || stop != end || !(ratio > 0)) {
      addError(diagnostics, "mark-syntax", {},
               fmt::format("--mark {}: no cost ratio after the colon", text),
               "write --mark NAME=VALUE,...:1.25");
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
                                                                  Diagnostics& diagnostics) {
  const std::vector<Camera>& cameras = input.asked.cameras;
  if (cameras.size() == 1) return std::pair(std::size_t{0}, text);
  const std::string name = text.substr(0, text.find('='));
  for (std::size_t i = 0; i < cameras.size() && name.size() < text.size(); ++i)
    if (cameras[i].name == name) return std::pair(i, text.substr(name.size() + 1));
  addError(diagnostics, "reference-camera", {},
           fmt::format("--reference {}: which of the cameras is this of?", text),
           "write --reference CAMERA=FILE for each");
  return std::nullopt;
}

/// Each view that has no reference.
void reportMissing(const StudyInput& input, Diagnostics& diagnostics) {
  for (std::size_t camera = 0; camera < input.asked.cameras.size(); ++camera) {
    const std::string& name = input.asked.cameras[camera].name;
    for (const ImageSize size : sizesOf(input.settings)) {
      if (input.references.contains({camera, size})) continue;
      addError(diagnostics, "reference-size", {},
               fmt::format("no --reference is {}x{} pixels large, from camera {}", size.width,
                           size.height, name),
               fmt::format("orris trace WORLD -o reference.exr --size {}x{} --camera {}",
                           size.width, size.height, name));
    }
  }
}

void readReferenceFiles(StudyInput& input, Diagnostics& diagnostics) {
  for (const std::string& text : input.asked.references) {
    const auto named = splitReference(text, input, diagnostics);
    if (!named) return;
    auto reference = readReference(named->second, diagnostics);
    if (!reference) continue;
    const ImageSize size{reference->mean.width, reference->mean.height};
    input.references[{named->first, size}] = std::move(*reference);
  }
  if (!hasErrors(diagnostics)) reportMissing(input, diagnostics);
}

/// Is it a setting, and not CAMERA=FILE or a file?
bool isSetting(const std::string& text, const StudyInput& input) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || std::filesystem::exists(text)) return false;
  const std::string name = text.substr(0, equals);
  return input.asked.cameras.size() == 1 || input.asked.world.camera(name) == nullptr;
}

void readReferences(StudyInput& input, Diagnostics& diagnostics) {
  const std::vector<std::string>& references = input.asked.references;
  if (references.empty()) {
    addError(diagnostics, "reference-missing", {}, "no --reference to measure errors against",
             "give a picture of orris trace, or a setting: --reference NAME=VALUE,...");
    return;
  }
  if (references.size() > 1 || !isSetting(references.front(), input))
    return readReferenceFiles(input, diagnostics);
  input.reference = parseSetting(references.front(), *input.pack, {}, diagnostics);
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
  addError(diagnostics, "baseline-unknown", {},
           fmt::format("--baseline {}: none of the settings is that", text),
           "name values of the axes");
}

void readStudySettings(StudyInput& study, Diagnostics& diagnostics) {
  std::vector<Axis> axes;
  for (const std::string& text : study.asked.axes) axes.push_back(parseAxis(text));
  const bool good = resolveAxes(axes, *study.pack, diagnostics);
  if (auto settings = good ? combine(axes, study.asked.size, diagnostics) : std::nullopt)
    study.settings = std::move(*settings);
  if (!study.asked.baseline.empty() && !study.settings.empty())
    chooseBaseline(study.asked.baseline, study, diagnostics);
  for (const std::string& text : study.asked.marks)
    if (auto mark = parseMark(text, *study.pack, diagnostics))
      study.marks.push_back(std::move(*mark));
}

SessionRequest sessionOf(const StudyRequest& asked) {
  SessionRequest session;
  session.openPack = [files = asked.files](Diagnostics&) { return files; };
  session.load = asked.load;
  session.versions = asked.versions;
  session.camera = asked.cameras.front();
  session.seed = asked.seed;
  return session;
}

}  // namespace

std::optional<StudyInput> readStudyInput(StudyRequest request, Diagnostics& diagnostics) {
  LoadRequest optionsOnly = request.load;
  optionsOnly.buildSources = false;
  auto pack = loadShaderPack(request.files, optionsOnly, diagnostics);
  if (!pack) return std::nullopt;
  StudyInput input{.asked = std::move(request)};
  input.session = sessionOf(input.asked);
  input.pack = std::make_shared<const ShaderPack>(std::move(*pack));
  Diagnostics found;
  readStudySettings(input, found);
  if (!hasErrors(found)) readReferences(input, found);
  const bool good = !hasErrors(found);
  diagnostics.insert(diagnostics.end(), found.begin(), found.end());
  return good ? std::optional(std::move(input)) : std::nullopt;
}

SessionRequest requestFor(const SessionRequest& base, const Setting& setting) {
  SessionRequest request = base;
  request.load = withSetting(base.load, setting);
  request.renderer.width = setting.size.width;
  request.renderer.height = setting.size.height;
  return request;
}

}  // namespace orris
