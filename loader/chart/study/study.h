// A pack measured in many settings over one world: what `orris chart` draws and `orris tune` chooses
// from.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <orris/chart/page/chart_data.h>
#include <orris/chart/study/digest.h>
#include <orris/chart/study/study_files.h>
#include <orris/chart/study/study_input.h>

namespace orris {

/// What the owner of a study sees and does while it goes on.
struct StudyHooks {
  std::function<void(Diagnostics& diagnostics)> report;  ///< must be set
  /// Called once, when the folder is made and no driver is loaded; may be empty.
  std::function<void()> beforeDriver;
  /// Work of so many frames begins: what is called with the number done; may be empty.
  std::function<std::function<void(int done)>(const std::string& what, int total)> begin;
};

class Study {
 public:
  /// Everything but measuring: pack, references, a context, what the folder holds already. nullptr:
  /// reported. `files` must outlive it.
  static std::unique_ptr<Study> open(StudyRequest request, const StudyFiles& files,
                                     StudyHooks hooks);

  const StudyInput& input() const { return input_; }
  const std::vector<Setting>& settings() const { return input_.settings; }
  /// Measures what is not known of these settings, beside the first of all. What the budget ends
  /// stays unmeasured; so does a setting that cannot be drawn, which is reported.
  void measure(const std::vector<std::size_t>& indices);
  bool timeLeft() const;

  std::size_t measured() const;  ///< settings of which all is known
  /// Of all cameras together. Holds until the next call.
  ChartData chart();

 private:
  Study(const StudyFiles& files, StudyHooks hooks) : files_(files), hooks_(std::move(hooks)) {}
  bool prepare(StudyRequest request);
  bool drawReferences();
  std::optional<ReferencePicture> reference(const View& view);
  std::string referenceName(const View& view) const;
  std::string jobLabel(const Setting& setting, std::size_t camera) const;
  SessionRequest request(const Setting& setting, std::size_t camera) const;
  SettingJob& job(std::size_t setting, std::size_t camera) {
    return jobs_[setting * input_.asked.cameras.size() + camera];
  }
  const ReferencePicture& referenceOf(const Setting& setting, std::size_t camera) const {
    return input_.references.at({camera, setting.size});
  }
  void makeJob(const Setting& setting, std::size_t camera);
  void measure(const std::vector<SettingJob*>& jobs);
  std::optional<ReferencePicture> drawReference(const SessionRequest& request);
  void makeJobs();
  void writePictures(const SettingJob& job, const ImageF& frame, const ImageF& mean);

  std::function<void(int)> begin(const std::string& what, int total) const;

  const StudyFiles& files_;
  StudyHooks hooks_;
  StudyInput input_;
  std::unique_ptr<gl::Context> context_;
  Digest digest_;
  std::vector<SettingJob> jobs_;         ///< of each setting, one for each camera
  SettingJob again_;                     ///< the first once more
  std::vector<SettingResult> combined_;  ///< of each setting, over the cameras
  std::optional<Measuring::Clock::time_point> end_;
};

}  // namespace orris
