// Settings judged on many scenes, each against its own path-traced picture: `orris chart --scenes`.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/output/report.h"
#include "app/study/study_options.h"

namespace orris {

struct SceneName {
  std::string world;   ///< as WORLD
  std::string camera;  ///< "" for the first
  bool operator==(const SceneName&) const = default;
};

/// "cornell", "h4_house@inside", and "random:SEED:N" for N rooms with the seeds SEED, SEED + 2, ... of one parity.
/// nullopt for a list that is malformed.
std::optional<std::vector<SceneName>> parseScenes(const std::vector<std::string>& list);

/// Measures all settings of the axes on every scene, each first traced with the options of --set, and writes
/// FOLDER/scenes.csv after each scene and FOLDER/settings/NAME.exr. Returns the exit status.
int runScenes(const StudyOptions& options, Report& report, nlohmann::json& result);

}  // namespace orris
