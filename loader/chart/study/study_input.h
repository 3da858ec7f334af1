// From what is asked of a study to the settings it measures and what they are measured against.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orris/chart/measure/measure.h>
#include <orris/chart/page/chart_data.h>
#include <orris/gl/context.h>
#include <orris/world/world.h>

namespace orris {

/// A pack over a world, what is varied of it, and how it is measured.
struct StudyRequest {
  std::shared_ptr<const FileSource> files;  ///< of the pack
  LoadRequest load;                         ///< what every setting has in common
  HostVersions versions;                    ///< of Iris and the game
  World world;
  std::vector<Camera> cameras;  ///< at least one; judged together
  unsigned seed = 0;
  ImageSize size{320, 180};             ///< of settings that name none
  std::string packName, worldName;      ///< for the title of the chart
  std::vector<std::string> axes;        ///< what is varied: parseAxis()
  std::vector<std::string> marks;       ///< published: "NAME=VALUE,...:RATIO"
  std::string baseline;                 ///< a setting that costs are multiples of; "": the first
  std::vector<std::string> references;  ///< files of readReference(), or one setting
  int referenceFrames = 1024;           ///< of a reference that is a setting
  const ErrorMetric* metric = findErrorMetric("error");
  int accumulate = 1;  ///< frames averaged before their error is taken
  MeasurePlan plan;
  gl::Backend backend = gl::Backend::Auto;
  std::optional<std::chrono::seconds> budget;  ///< nullopt: until all is done
};

/// A place and how many pixels it is seen with.
struct View {
  std::size_t camera = 0;  ///< index
  ImageSize size;
  auto operator<=>(const View&) const = default;
};

struct StudyInput {
  StudyRequest asked;
  SessionRequest session;                  ///< without any setting; the first camera
  std::shared_ptr<const ShaderPack> pack;  ///< options only
  std::vector<Setting> settings;           ///< the baseline first
  std::vector<PublishedMark> marks;
  std::map<View, ReferencePicture> references;  ///< read from files
  std::optional<Setting> reference;             ///< the setting that is to be drawn instead
};

/// nullopt: the pack does not load, or what is asked of it cannot be.
std::optional<StudyInput> readStudyInput(StudyRequest request, Diagnostics& diagnostics);

/// The request of one setting.
SessionRequest requestFor(const SessionRequest& base, const Setting& setting);

}  // namespace orris
