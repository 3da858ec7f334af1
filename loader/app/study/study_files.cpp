#include "app/study/study_files.h"

#include <fmt/format.h>

#include <filesystem>

#include "app/input/inputs.h"
#include "chart/measure/setting.h"
#include "core/read_file.h"

namespace orris {
namespace {

void note(Report& report, Severity severity, const std::string& path, std::string message) {
  Diagnostic diagnostic;
  diagnostic.severity = severity;
  diagnostic.id = "study-file";
  diagnostic.at.file = path;
  diagnostic.message = std::move(message);
  Diagnostics diagnostics = {std::move(diagnostic)};
  report.add(diagnostics);
}

}  // namespace

bool StudyFiles::create(Report& report) const {
  std::error_code error;
  const std::string settings = (std::filesystem::path(folder_) / "settings").string();
  std::filesystem::create_directories(settings, error);
  const bool outside = !error && !liesBelow(folder_, settings);
  if (!error && !outside) return true;
  report.error("file-unwritable",
               outside ? "its folder settings is a link that leads out of it"
                       : "the folder cannot be made: " + error.message(),
               "name a folder in a place that may be written", folder_);
  return false;
}

std::string StudyFiles::path(const std::string& name, const std::string& ending) const {
  return (std::filesystem::path(folder_) / "settings" / (name + ending)).string();
}

std::string StudyFiles::settingPath(const std::string& label, const std::string& ending) const {
  return path(fileStem(label), ending);
}

SettingResult StudyFiles::read(const std::string& label, const std::string& key,
                               Report& report) const {
  SettingResult fresh;
  fresh.label = label;
  fresh.key = key;
  const std::string file = settingPath(label, ".json");
  if (!std::filesystem::exists(file)) return fresh;
  const std::optional<std::string> text = readWholeFile(file, report);
  std::optional<SettingResult> result = text ? parseResult(*text) : std::nullopt;
  if (!result) {
    note(report, Severity::Warning, file, "is no result; the setting is measured again");
    return fresh;
  }
  if (result->label == label && result->key == key) return std::move(*result);
  note(report, Severity::Warning, file,
       "was measured with another pack, world, reference or plan; it is measured again");
  return fresh;
}

bool StudyFiles::write(const SettingResult& result, Report& report) const {
  return writeWholeFile(settingPath(result.label, ".json"), writeResult(result), report);
}

}  // namespace orris
