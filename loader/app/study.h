// A pack measured in many settings over one world: what `orris chart` draws and `orris tune` chooses
// from.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "app/report.h"
#include "app/study_files.h"
#include "app/study_input.h"
#include "chart/chart_data.h"
#include "chart/digest.h"

namespace orris {

class Study {
 public:
  /// Everything but measuring: pack, world, references, what the folder holds already. nullptr:
  /// reported, `status` is set. All arguments must outlive it.
  static std::unique_ptr<Study> open(const StudyOptions& options, const StudyFiles& files,
                                     Report& report, int& status);

  const StudyInput& input() const { return input_; }
  const std::vector<Setting>& settings() const { return input_.settings; }
  /// Measures what is not known of these settings, beside the first of all. What the budget ends
  /// stays unmeasured; so does a setting that cannot be drawn, which is reported.
  void measure(const std::vector<std::size_t>& indices);
  bool timeLeft() const;

  std::size_t measured() const;  ///< settings of which all is known
  ChartData chart() const;

 private:
  Study(const StudyOptions& options, const StudyFiles& files, Report& report, int& status)
      : options_(options), files_(files), report_(report), status_(status) {}
  bool prepare();
  bool drawReferences();
  std::optional<ReferencePicture> reference(ImageSize size);
  std::optional<ReferencePicture> drawReference(const SessionRequest& request);
  void makeJobs();
  void writePictures(const SettingJob& job, const ImageF& frame, const ImageF& mean);

  const StudyOptions& options_;
  const StudyFiles& files_;
  Report& report_;
  int& status_;
  StudyInput input_;
  std::unique_ptr<gl::Context> context_;
  Digest digest_;
  std::vector<SettingJob> jobs_;  ///< of the settings
  SettingJob again_;              ///< the first once more
  std::optional<Measuring::Clock::time_point> end_;
};

}  // namespace orris
