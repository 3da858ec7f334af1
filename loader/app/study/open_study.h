// From the flags of `orris chart` and `orris tune` to a study.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/drawing/file_broker.h"
#include "app/output/report.h"
#include "app/study/study_options.h"
#include <orris/chart/study/study.h>

namespace orris {

/// Opens the world; `files` are the pack's. nullopt: reported.
std::optional<StudyRequest> makeStudyRequest(const StudyOptions& options, const std::shared_ptr<const FileSource>& files,
                                             Report& report);

/// What the process that measures may write: all in the folder.
AllowedFiles filesOfStudy(const std::string& folder);

/// Reports and shows the progress of a study, and shuts this process in before a driver is loaded
/// (confineDrawing(), where open files `keep` stay). `files` and `report` must outlive them.
StudyHooks studyHooks(const StudyFiles& files, std::vector<int> keep, Report& report);

/// Study::open() of what the flags ask for, with a progress line. `files` and `report` must outlive it; of open
/// files `keep` stay.
std::unique_ptr<Study> openStudy(const StudyOptions& options, const StudyFiles& files, std::vector<int> keep,
                                 Report& report);

}  // namespace orris
