// `orris chart --scenes`: from flags to a study of many scenes.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/output/report.h"
#include "app/study/study_options.h"

namespace orris {

/// Measures all settings of the axes on every scene, each first traced with the options of --set, and writes
/// FOLDER/scenes.csv after each scene and FOLDER/settings/NAME.exr. Returns the exit status.
int runScenes(const StudyOptions& options, Report& report, nlohmann::json& result);

}  // namespace orris
