#include <orris/chart/study/study_files.h>

#include <fmt/format.h>

#include <filesystem>

#include <orris/chart/measure/setting.h>
#include <orris/core/add_diagnostic.h>
#include <orris/core/files/named_file.h>
#include <orris/core/files/read_file.h>

namespace orris {
bool StudyFiles::create(Diagnostics& diagnostics) const {
  std::error_code error;
  const std::string settings = (std::filesystem::path(folder_) / "settings").string();
  std::filesystem::create_directories(settings, error);
  const bool outside = !error && !liesBelow(folder_, settings);
  if (!error && !outside) return true;
  diagnostics.push_back({.id = "file-unwritable",
                         .at = {.file = folder_},
                         .message = outside ? "its folder settings is a link that leads out of it"
                                            : "the folder cannot be made: " + error.message(),
                         .hint = "name a folder in a place that may be written"});
  return false;
}

std::string StudyFiles::path(const std::string& name, const std::string& ending) const {
  return (std::filesystem::path(folder_) / "settings" / (name + ending)).string();
}

std::string StudyFiles::settingPath(const std::string& label, const std::string& ending) const {
  return path(fileStem(label), ending);
}

SettingResult StudyFiles::read(const std::string& label, const std::string& key,
                               Diagnostics& diagnostics) const {
  SettingResult fresh;
  fresh.label = label;
  fresh.key = key;
  const std::string file = settingPath(label, ".json");
  if (!std::filesystem::exists(file)) return fresh;
  const std::optional<std::string> text = readNamedFile(file, diagnostics);
  std::optional<SettingResult> result = text ? parseResult(*text) : std::nullopt;
  if (!result) {
    addWarning(diagnostics, "study-file", {file}, "is no result; the setting is measured again");
    return fresh;
  }
  if (result->label == label && result->key == key) return std::move(*result);
  addWarning(diagnostics, "study-file", {file},
             "was measured with another pack, world, reference or plan; it is measured again");
  return fresh;
}

bool StudyFiles::write(const SettingResult& result, Diagnostics& diagnostics) const {
  return writeNamedFile(settingPath(result.label, ".json"), writeResult(result), diagnostics);
}

}  // namespace orris
