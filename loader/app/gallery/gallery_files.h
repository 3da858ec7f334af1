// The folder of a gallery: each picture and its numbers as plain files, so that a later run, or one that other
// machines' files were copied to, goes on from there.
//
//   pictures/NAME.png, NAME.json            of the pack
//   pictures/NAME.before.png, .before.json  of --against
#pragma once

#include <optional>
#include <string>

#include "app/gallery/gallery_drawing.h"

namespace orris {

/// What a picture depends on: pack, world, choices, driver, this program.
class GalleryKeys {
 public:
  GalleryKeys(const GalleryOptions& options, const GalleryInput& input);
  std::string key(const GalleryJob& job) const;

 private:
  const GalleryOptions& options_;
  const GalleryInput& input_;
  std::uint64_t pack_ = 0, packBefore_ = 0;
  std::vector<std::uint64_t> worlds_;
};

class GalleryFiles {
 public:
  /// Of a folder; "" keeps nothing.
  explicit GalleryFiles(std::string folder) : folder_(std::move(folder)) {}
  /// false: reported, `status` is set.
  bool create(Report& report, int& status) const;
  /// The picture if it was drawn under the same key.
  std::optional<GalleryPicture> read(const std::string& name, const std::string& key,
                                     ImageSize size) const;
  bool write(const std::string& name, const std::string& key, const GalleryPicture& picture,
             Report& report, int& status) const;

 private:
  std::string path(const std::string& name, const char* ending) const;
  std::string folder_;
};

}  // namespace orris
