// Settings judged on many scenes, each against its own path-traced picture.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include <orris/chart/scenes/row_meter.h>
#include <orris/chart/scenes/scene_names.h>
#include <orris/chart/study/study.h>

namespace orris {

struct SceneStudyRequest {
  std::vector<SceneName> scenes;
  /// The pack over one scene, whose only reference is a picture that was traced of it. nullopt: reported.
  std::function<std::optional<StudyRequest>(const SceneName& scene)> open;
  RowPlan plan;
  gl::Backend backend = gl::Backend::Auto;
  std::optional<std::chrono::seconds> budget;  ///< no scene is begun after it; nullopt: until all is done
};

/// All settings of the axes on every scene, and FOLDER/scenes.csv after each scene. nullopt: reported.
std::optional<std::vector<SceneRow>> measureScenes(const SceneStudyRequest& request, const StudyFiles& files,
                                                   const StudyHooks& hooks);

}  // namespace orris
