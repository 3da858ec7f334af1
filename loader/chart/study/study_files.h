// The folder of a study: what is known of each setting as plain files, so that a later run, or one
// that other machines' files were copied to, goes on from there.
//
//   settings/NAME.json        numbers (chart/measure/setting_result.h)
//   settings/NAME.png         the last frame that was measured, as displayed
//   settings/NAME.mean.png    the mean of all
//   settings/NAME.error.png   where the mean is too bright and too dark
//   settings/reference-WxH.*  a reference that was drawn, and each as displayed
// NAME is the setting's; with "from CAMERA" behind it for all cameras but the first.
#pragma once

#include <optional>
#include <string>

#include <orris/chart/measure/reference_picture.h>
#include <orris/chart/measure/setting_result.h>
#include <orris/core/diagnostic.h>

namespace orris {

class StudyFiles {
 public:
  explicit StudyFiles(std::string folder) : folder_(std::move(folder)) {}

  const std::string& folder() const { return folder_; }
  /// Makes the folders. false: reported.
  bool create(Diagnostics& diagnostics) const;

  /// Of a setting by label, or of a reference by "reference-320x180".
  std::string path(const std::string& name, const std::string& ending) const;
  std::string settingPath(const std::string& label, const std::string& ending) const;

  /// What is known of the setting, if it was measured under the same key; else an empty result with
  /// that key.
  SettingResult read(const std::string& label, const std::string& key,
                     Diagnostics& diagnostics) const;
  bool write(const SettingResult& result, Diagnostics& diagnostics) const;

 private:
  std::string folder_;
};

}  // namespace orris
