// A pack measured in many settings over one world: what `orris chart` draws and `orris tune` chooses
// from.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "app/report.h"
#include "app/study_files.h"
#include "app/study_options.h"
#include "chart/chart_data.h"

namespace orris {

struct Study {
  std::unique_ptr<ShaderPack> pack;  ///< without the options of any setting
  std::shared_ptr<const FileSource> files;
  Camera camera;
  std::string driver;
  std::vector<Setting> settings;  ///< the baseline first
  std::vector<SettingJob> jobs;   ///< of the settings
  SettingJob again;               ///< the baseline once more
  std::map<ImageSize, ReferencePicture> references;
  std::vector<PublishedMark> marks;

  std::size_t measured(const MeasurePlan& plan) const;  ///< settings of which all is known
  ChartData chart(const StudyOptions& options) const;
};

/// Measures what the folder does not hold yet. nullptr: reported, `status` is set. A study that the
/// budget ended is returned with what it has; so is one in which some settings cannot be drawn.
std::unique_ptr<Study> runStudy(const StudyOptions& options, const StudyFiles& files,
                                Report& report, int& status);

}  // namespace orris
