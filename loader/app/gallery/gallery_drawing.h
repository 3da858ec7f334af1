// Pictures of a gallery, each drawn in a process that may die or not come back.
#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "app/gallery/gallery_input.h"
#include <orris/chart/gallery/gallery_picture.h>

namespace orris {

struct GalleryJob {
  std::size_t shot = 0;
  bool before = false;  ///< of the revision of --against
};

/// `picture` is empty where it could not be drawn: `diagnostics` say why.
struct GalleryDrawn {
  std::optional<GalleryPicture> picture;
  Diagnostics diagnostics;
};

FrameClock galleryClock(const GalleryOptions& options);

/// Draws one after another and hands each over; what `until` ends is not handed over.
void drawGallery(const GalleryOptions& options, const GalleryInput& input,
                 const std::vector<GalleryJob>& jobs,
                 std::optional<std::chrono::steady_clock::time_point> until,
                 const std::function<void(std::size_t job, GalleryDrawn drawn)>& take);

}  // namespace orris
