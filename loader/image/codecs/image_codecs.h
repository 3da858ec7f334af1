// What the module of picture codecs offers. OpenImageIO stays inside of the module: its 260 shared
// libraries take a fifth of a second to load and tens of megabytes, and most commands read and write no
// picture but PNG (image/png_file.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/image/image.h>

namespace orris {

/// A picture file opened for reading; its pixels are still in the file.
class PictureReader {
 public:
  virtual ~PictureReader() = default;
  /// As the file states them: nothing of it is checked yet.
  int width = 0, height = 0, depth = 0, channels = 0;
  /// All pixels with the file's own channels, row-major, top row first, colour as stored (not
  /// multiplied by alpha). `pixels` holds width * height * channels values. Returns the reason on
  /// failure, nothing on success.
  virtual std::optional<std::string> read(std::uint8_t* pixels) = 0;
  virtual std::optional<std::string> read(float* pixels) = 0;
};

/// Pixels on their way into a file; exactly one of `bytes` and `floats` is set.
struct PictureToWrite {
  int width = 0, height = 0, channels = 0;
  const std::uint8_t* bytes = nullptr;
  const float* floats = nullptr;
  bool storeBytes = false;                ///< 8 bits a channel in the file, else 32 bit floats
  std::vector<std::string> channelNames;  ///< empty: the format's own
};

class ImageCodecs {
 public:
  virtual ~ImageCodecs() = default;
  /// Opens a file in memory as `format` (OpenImageIO's name of it); `bytes` must outlive the reader.
  /// nullptr and a reason when it is no such picture.
  virtual std::unique_ptr<PictureReader> open(const std::string& bytes, const std::string& format,
                                              std::string& reason) const = 0;
  /// Opens a file by path, whatever format it has.
  virtual std::unique_ptr<PictureReader> open(const std::string& path,
                                              std::string& reason) const = 0;
  /// Whether an extension (".png") names a format that can be written.
  virtual bool canWrite(const std::string& extension) const = 0;
  /// Writes `path` as the format of `extension`. Returns the reason on failure.
  virtual std::optional<std::string> write(const std::string& path, const std::string& extension,
                                           const PictureToWrite& picture) const = 0;
};

/// The name of the one function that the module exports: `const ImageCodecs* orrisImageCodecs()`.
inline constexpr const char* kImageCodecsFunction = "orrisImageCodecs";

/// The file of the module, which a process must be able to read until it has loaded it; "" when there is none.
std::string imageCodecsFile();

/// The codecs, loaded at the first call of the process. nullptr and a diagnostic that names `picture`
/// when the module cannot be loaded.
const ImageCodecs* imageCodecs(const std::string& picture, Diagnostics& diagnostics);

}  // namespace orris
