// A gallery as one HTML file that needs nothing beside it, and can be read without scripts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orris/chart/gallery/gallery_change.h>

namespace orris {

/// A revision of a picture. Without numbers it could not be drawn.
struct GalleryRevision {
  std::optional<GalleryPicture> picture;
  std::string png;                    ///< the same as a file
  std::vector<std::string> problems;  ///< messages, of several lines each
};

struct GalleryEntry {
  std::string name;
  GalleryRevision after, before;
  std::optional<PictureChange> change;  ///< where both are there
  std::string differencePng;            ///< "" where they are equal
};

struct Gallery {
  std::string title;
  std::vector<std::pair<std::string, std::string>> facts;  ///< name, text
  bool against = false;                                    ///< with another revision
  std::vector<FileChange> files;                           ///< of the pack
  std::vector<GalleryEntry> entries;                       ///< in the order of the set
};

/// With another revision those that could not be drawn come first, then by falling change.
std::string galleryPage(const Gallery& gallery);

/// gallery.html, which the build puts into the library, with "<!--TITLE-->" and "<!--BODY-->".
extern const std::string_view kGalleryTemplate;

}  // namespace orris
