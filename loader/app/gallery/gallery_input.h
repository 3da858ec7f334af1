// From the command line to what a gallery is drawn of.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/gallery/gallery_options.h"
#include "app/output/report.h"
#include <orris/chart/gallery/gallery_set.h>
#include <orris/core/files/file_source.h>
#include <orris/gl/context.h>

namespace orris {

struct GalleryInput {
  std::shared_ptr<const FileSource> files, filesBefore;  ///< the latter nullptr without --against
  GallerySet set;
  std::vector<std::string> worlds;  ///< of each shot, as loadScene() takes it
  gl::DriverInfo driver;
  ImageSize size;
  int frames = 0;
};

/// nullopt: reported, `status` is set.
std::optional<GalleryInput> readGalleryInput(const GalleryOptions& options, Report& report,
                                             int& status);

}  // namespace orris
