// From the command line to the settings of a study and what they are measured against.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/report/report.h"
#include "app/study/study_options.h"
#include "chart/page/chart_data.h"
#include "world/world.h"

namespace orris {

/// A place and how many pixels it is seen with.
struct View {
  std::size_t camera = 0;  ///< index
  ImageSize size;
  auto operator<=>(const View&) const = default;
};

struct StudyInput {
  World world;
  std::shared_ptr<const FileSource> files;
  std::shared_ptr<const ShaderPack> pack;  ///< options only, those of the command line in force
  SessionRequest request;         ///< of the command line, without any setting; the first camera
  std::vector<Camera> cameras;    ///< at least one
  std::vector<Setting> settings;  ///< the baseline first
  std::vector<PublishedMark> marks;
  std::map<View, ReferencePicture> references;  ///< read from files
  std::optional<Setting> reference;             ///< the setting that is to be drawn instead
};

/// nullopt: reported.
std::optional<StudyInput> readStudyInput(const StudyOptions& options, Report& report);

/// The request of one setting.
SessionRequest requestFor(const SessionRequest& base, const Setting& setting);

}  // namespace orris
