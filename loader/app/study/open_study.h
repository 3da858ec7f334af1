// From the flags of `orris chart` and `orris tune` to a study.
#pragma once

#include <memory>
#include <optional>

#include "app/output/report.h"
#include "app/study/study_options.h"
#include <orris/chart/study/study.h>

namespace orris {

/// Opens the pack and the world. nullopt: reported.
std::optional<StudyRequest> makeStudyRequest(const StudyOptions& options, Report& report);

/// Reports and shows the progress of a study. `report` must outlive them.
StudyHooks studyHooks(Report& report);

/// Study::open() of what the flags ask for, with a progress line. `files` and `report` must outlive it.
std::unique_ptr<Study> openStudy(const StudyOptions& options, const StudyFiles& files,
                                 Report& report);

}  // namespace orris
