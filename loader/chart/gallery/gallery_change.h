// What differs between two revisions of a picture.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <orris/chart/gallery/gallery_picture.h>
#include <orris/core/files/file_source.h>

namespace orris {

/// Of a pass, a program or a file.
enum class Difference { Same, Changed, Added, Removed };
const char* differenceName(Difference difference);  ///< "same", "changed", ...

struct PassChange {
  std::string name;
  Difference kind = Difference::Same;  ///< Changed: the text of its program, or which program it is
  std::optional<double> before, after; ///< milliseconds
  std::string why;                     ///< "fragment, by /lib/sky.glsl"
};

struct PictureChange {
  bool equal = false;   ///< byte for byte
  /// 1 - SSIM (image/image_compare.h) of that of the channels red, green and blue which changed most, 0 to 2:
  /// that of luma would miss another hue.
  double change = 0;
  double rmse = 0;      ///< of values 0..1
  double share = 0;     ///< of pixels that differ by more than 1/255
  std::vector<PassChange> passes;  ///< of the newer revision in frame order, then removed ones
};

struct FileChange {
  std::string file;
  Difference kind = Difference::Same;
  bool operator==(const FileChange&) const = default;
};

/// Files of a pack that differ, sorted by name.
std::vector<FileChange> changedFiles(const FileSource& before, const FileSource& after);

/// `files`: those that differ. Sizes of both pictures must be equal.
PictureChange comparePictures(const GalleryPicture& before, const GalleryPicture& after,
                              const std::vector<FileChange>& files);

/// As `orris compare --diff` makes it.
Image8 shownDifference(const Image8& before, const Image8& after);

}  // namespace orris
