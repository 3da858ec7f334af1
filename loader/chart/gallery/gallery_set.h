// Which pictures a gallery shows: worlds seen from cameras, by time, weather and profile. docs/gallery.md
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <orris/image/image_size.h>
#include <orris/pack/options/options.h>
#include <orris/world/files/located_json.h>
#include <orris/world/world.h>

namespace orris {

inline constexpr std::size_t kMaxGalleryPictures = 256;
inline constexpr std::size_t kGallerySetBytes = std::size_t{256} << 10;
inline constexpr int kMaxGalleryFrames = 10'000;
inline constexpr const char* kGallerySetFile = "gallery.json";

/// One picture.
struct GalleryShot {
  std::string name;  ///< unique in its set: "terrain, shore, 6000, rain, LOW"
  std::string world, camera;  ///< as the set names them; camera "": the first
  std::optional<int> time;    ///< ticks; nullopt: the world's own
  std::string weather;        ///< of galleryWeathers(), "": the world's own
  std::string profile;        ///< "": that of the command line
  OptionValues values;        ///< over the profile
  SourceLocation at;          ///< in the set's file
  std::size_t worldOffset = 0;  ///< the same of the world's name, in bytes
};

struct GallerySet {
  std::string name;  ///< "default", or the file
  std::optional<ImageSize> size;
  std::optional<int> frames;
  std::vector<GalleryShot> shots;
};

/// What comes with Orris, in the language of gallery.json.
extern const char* const kDefaultGallerySet;

/// Reads a set. Scenes that name no profiles get `profiles`, those that do name some of `known`; "all" stands for
/// `known`. nullopt and located diagnostics (gallery-set) for what is no such set.
std::optional<GallerySet> parseGallerySet(const JsonText& source,
                                          const std::vector<std::string>& profiles,
                                          const std::vector<std::string>& known,
                                          Diagnostics& diagnostics);

/// "clear", "rain", "thunder".
std::vector<std::string> galleryWeathers();
/// false: there is no such weather. "" changes nothing.
bool applyWeather(const std::string& weather, Environment& environment);

}  // namespace orris
