#include "app/pack_choices.h"

#include <filesystem>

#include "app/inputs.h"

namespace orris {
namespace {

std::filesystem::path withoutEndSlash(const std::filesystem::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

std::string packNameOf(const std::string& packPath) {
  return withoutEndSlash(packPath).filename().string();
}

std::string optionFileOf(const std::string& packPath) {
  return withoutEndSlash(packPath).string() + ".txt";
}

PackChoices::PackChoices(const PackOptions& options)
    : commandLine_(options.values),
      optionFile_(options.settingsFile.empty() ? optionFileOf(options.path) : options.settingsFile),
      required_(!options.settingsFile.empty()) {}

std::optional<OptionValues> PackChoices::read(const PackOpener& openPack,
                                              const LoadRequest& request, bool withOptionFile,
                                              Report& report) const {
  OptionValues values;
  if (withOptionFile && (required_ || std::filesystem::exists(optionFile_))) {
    int status = kClean;
    const std::optional<std::string> text = readWholeFile(optionFile_, report, status);
    if (!text) return std::nullopt;
    LoadRequest optionsOnly = request;
    optionsOnly.values.clear();
    optionsOnly.profile.clear();
    optionsOnly.buildSources = false;
    // What is wrong with the pack itself is told by the load that follows.
    Diagnostics ignored, diagnostics;
    const auto files = openPack(ignored);
    const auto pack = files ? loadShaderPack(files, optionsOnly, ignored) : std::nullopt;
    if (pack) values = parseOptionFile(optionFile_, *text, pack->options, diagnostics);
    report.add(diagnostics);
  }
  for (const auto& [name, value] : commandLine_) values[name] = value;
  return values;
}

OptionValues PackChoices::setSince(const OptionValues& current) const {
  OptionValues result;
  for (const auto& [name, value] : current) {
    const auto known = accepted_.find(name);
    if (known == accepted_.end() || known->second != value) result.emplace(name, value);
  }
  return result;
}

}  // namespace orris
