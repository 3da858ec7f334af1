// The flags of `orris gallery`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/drawing/supervised_run.h"
#include "app/input/common.h"

namespace orris {

struct GalleryOptions {
  PackOptions pack;
  std::string against;  ///< another revision of the pack, "" for none
  std::string output;   ///< a file .html, or a folder
  std::string setFile;  ///< "": gallery.json beside shaders/, else the default set
  std::vector<std::string> profiles;  ///< of scenes that name none; "all"
  std::optional<double> failAbove;
  ImageOptions image{.width = 480, .height = 270, .frames = 24};
  bool sizeGiven = false, framesGiven = false;  ///< go before those of the set
  bool allowMissing = false;                    ///< as of `orris render`
  std::string budget, shard;
  WorkLimits limits;
  OutputOptions report;
};

}  // namespace orris
