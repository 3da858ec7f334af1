// One picture of a gallery: drawn, with what it cost and what it was made by.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/chart/measure/setting_session.h>
#include <orris/image/image.h>

namespace orris {

struct GalleryPass {
  std::string name;
  double milliseconds = 0;  ///< median
  std::string program;      ///< "" for what the host does itself
  bool operator==(const GalleryPass&) const = default;
};

/// A program that the frame uses, as the driver gets it.
struct GalleryProgram {
  std::map<std::string, std::uint64_t> stages;  ///< hash of the text by stage, or by name of a compute
  std::vector<std::string> files;               ///< of the pack, that it is made from; sorted
  bool operator==(const GalleryProgram&) const = default;
};

struct GalleryPicture {
  Image8 image;             ///< RGB as displayed
  double milliseconds = 0;  ///< of a frame, median
  std::vector<GalleryPass> passes;  ///< in frame order
  std::map<std::string, GalleryProgram> programs;
  std::vector<std::string> leftOut;  ///< programs that this driver cannot run
};

struct GalleryWork {
  /// The last one is the picture. The first half lasts long each, so that exposure and what else follows the
  /// light has settled; the second half is timed.
  int frames = 0;
  FrameClock clock = FrameClock::Wall;
};

/// nullopt: see diagnostics.
std::optional<GalleryPicture> drawGalleryPicture(gl::Context& context, SessionRequest request,
                                                 World world, const GalleryWork& work,
                                                 Diagnostics& diagnostics);

/// All but the pixels as JSON, for files; and back. nullopt: the text is none.
std::string writeGalleryNumbers(const GalleryPicture& picture);
std::optional<GalleryPicture> parseGalleryNumbers(std::string_view text);

/// Three channels of a picture that has at least so many.
Image8 withoutAlpha(const Image8& image);

}  // namespace orris
