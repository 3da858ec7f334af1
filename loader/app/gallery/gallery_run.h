// `orris gallery` from its flags to the page.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/gallery/gallery_options.h"
#include "app/output/report.h"

namespace orris {

/// Returns the exit status; `result` is for --json.
int runGallery(const GalleryOptions& options, Report& report, nlohmann::json& result);

}  // namespace orris
