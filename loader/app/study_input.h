// From the command line to the settings of a study and what they are measured against.
#pragma once

#include <optional>

#include "app/study.h"

namespace orris {

/// World and base request; fills in pack, settings, marks and camera. nullopt: reported, `status` is
/// set.
struct StudyInput {
  World world;
  SessionRequest request;            ///< of the command line, without any setting
  std::optional<Setting> reference;  ///< the setting that is the reference, if no file is
};
std::optional<StudyInput> readStudyInput(const StudyOptions& options, Study& study, Report& report,
                                         int& status);

/// The request of one setting.
SessionRequest requestFor(const SessionRequest& base, const Setting& setting);

}  // namespace orris
