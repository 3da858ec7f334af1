// The flags that say what `orris chart` and `orris tune` measure.
#pragma once

#include <string>
#include <vector>

#include "app/drawing/supervised_run.h"
#include "app/input/common.h"
#include <orris/chart/measure/measure.h>

namespace orris {

/// --scenes: many scenes instead of one WORLD.
struct SceneListOptions {
  std::vector<std::string> names;  ///< as parseScenes() takes them
  int runs = 4;                    ///< with random numbers of their own
  double traceSeconds = 30, traceNoise = 0.005;
  bool costs = true;
};

struct StudyOptions {
  PackOptions pack;
  SceneOptions scene;
  ImageOptions image{.width = 320, .height = 180};
  OutputOptions output;
  std::string folder;  ///< for everything that is measured
  std::vector<std::string> axes, marks;
  std::vector<std::string> cameras;     ///< of the world, seen together; none: that of --camera
  std::string baseline;                 ///< a setting; "": the first
  std::vector<std::string> references;  ///< files, or one setting
  int referenceFrames = 1024;
  std::string metric = "error";
  int accumulate = 1;
  MeasurePlan plan;
  SceneListOptions scenes;  ///< of `orris chart` only
  std::string budget, shard;
  WorkLimits limits;
};

/// All but the positional arguments and the folder.
void addStudyFlags(CLI::App& command, StudyOptions& options);

}  // namespace orris
