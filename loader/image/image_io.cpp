#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include <orris/core/add_diagnostic.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/replace_file.h>
#include <orris/image/codecs/image_codecs.h>
#include <orris/image/image.h>
#include <orris/image/image_size.h>
#include <orris/image/png_file.h>

namespace orris {
namespace {

constexpr std::int64_t kMaxFilePixels = std::int64_t(1) << 26;
constexpr int kMaxChannels = 16;

/// Format of an image by its first bytes; the name decides only for TGA, which has no signature.
/// A pack's file name never reaches OpenImageIO, so it cannot make it open something else.
std::string formatOf(std::string_view bytes, std::string_view name) {
  struct Signature {
    std::string_view bytes;
    const char* format;
  };
  static constexpr std::array<Signature, 5> kSignatures{{{"\x89PNG", "png"},
                                                         {"\xff\xd8\xff", "jpeg"},
                                                         {"BM", "bmp"},
                                                         {"#?RADIANCE", "hdr"},
                                                         {"\x76\x2f\x31\x01", "openexr"}}};
  for (const Signature& signature : kSignatures) {
    if (bytes.starts_with(signature.bytes)) return signature.format;
  }
  return name.ends_with(".tga") || name.ends_with(".TGA") ? "targa" : "";
}

/// Walks the chunks to the end mark: a cut file has one message wherever it ends.
bool isWholePng(std::string_view bytes) {
  constexpr size_t kSignature = 8, kFrame = 12;  // length, type and checksum around each chunk
  size_t at = kSignature;
  while (at + kFrame <= bytes.size()) {
    const auto byte = [&](size_t i) { return size_t(std::uint8_t(bytes[at + i])); };
    const size_t length = byte(0) << 24 | byte(1) << 16 | byte(2) << 8 | byte(3);
    if (length > bytes.size() - at - kFrame) return false;
    if (bytes.substr(at + 4, 4) == "IEND") return true;
    at += kFrame + length;
  }
  return false;
}

/// `picture` has a width, a height and channels: a PictureReader or a PngHeader.
bool sizeAllowed(const auto& picture, const std::string& name, Diagnostics& diagnostics) {
  const bool allowed = picture.width > 0 && picture.height > 0 && picture.width <= kMaxSide &&
                       picture.height <= kMaxSide &&
                       std::int64_t(picture.width) * picture.height <= kMaxFilePixels &&
                       picture.channels > 0 && picture.channels <= kMaxChannels;
  if (allowed) return true;
  return addError(diagnostics, "image-size", {name},
                  fmt::format("image of {}x{} with {} channels is outside the limits",
                              picture.width, picture.height, picture.channels),
                  fmt::format("at most {0}x{0}, {1} pixels in all", kMaxSide, kMaxFilePixels));
}

bool isFlat(const PictureReader& picture, const std::string& name, Diagnostics& diagnostics) {
  if (picture.depth <= 1) return sizeAllowed(picture, name, diagnostics);
  return addError(diagnostics, "image-size", {name}, "the image has layers", "save one of them");
}

Image8 toRgba(const Image8& source) {
  Image8 result(source.width, source.height, 4);
  const int channels = source.channels;
  const bool grey = channels <= 2;
  const size_t count = size_t(source.width) * source.height;
  for (size_t i = 0; i < count; ++i) {
    const std::uint8_t* from = &source.pixels[i * channels];
    std::uint8_t* to = &result.pixels[i * 4];
    for (int c = 0; c < 3; ++c) to[c] = grey ? from[0] : from[c];
    to[3] = channels == 2 ? from[1] : channels >= 4 ? from[3] : 255;
  }
  return result;
}

std::string lowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

bool storesBytes(const std::string& path, bool fromBytes) {
  if (isDisplayFormat(path)) return true;
  const std::string extension = lowerExtension(path);
  const bool floatOnly = extension == ".exr" || extension == ".pfm" || extension == ".hdr";
  return fromBytes && !floatOnly;
}

bool reportUnwritten(const std::string& path, const std::error_code& error,
                     const std::string& problem, Diagnostics& diagnostics) {
  return addError(
      diagnostics, "image-write", {path},
      fmt::format("cannot write the image: {}", problem.empty() ? error.message() : problem),
      "check that the folder exists and is writable");
}

/// A PNG file of at most 8 bits a channel. nullopt: the module has to read it, or to say why it cannot be read.
std::optional<ImageF> readPlainPng(const std::string& path) {
  if (lowerExtension(path) != ".png") return std::nullopt;
  ReadFault fault{};
  const auto bytes = readFile(path, kMaxTextBytes, fault);
  std::string reason;
  Diagnostics refused;
  const auto header = bytes ? readPngHeader(*bytes, reason) : std::nullopt;
  if (!header || header->bits > 8 || !sizeAllowed(*header, path, refused)) return std::nullopt;
  const auto stored = decodePng(*bytes, reason);
  if (!stored) return std::nullopt;
  ImageF image(stored->width, stored->height, stored->channels);
  std::ranges::transform(stored->pixels, image.pixels.begin(), [](std::uint8_t value) { return float(value) / 255; });
  return image;
}

Image8 toBytes(const ImageF& image) {
  Image8 bytes(image.width, image.height, image.channels);
  for (std::size_t i = 0; i < bytes.pixels.size(); ++i) {
    const float value = image.pixels[i];
    // NaN becomes 0.
    bytes.pixels[i] = value > 0 ? std::uint8_t(std::min(value, 1.0f) * 255 + 0.5f) : std::uint8_t(0);
  }
  return bytes;
}

bool writePng(const std::string& path, const Image8& image, Diagnostics& diagnostics) {
  std::string reason;
  const auto bytes = pngOf(image, reason);
  if (!bytes) return reportUnwritten(path, {}, reason, diagnostics);
  const std::error_code error = replaceFile(path, *bytes);
  return !error || reportUnwritten(path, error, outputProblem(path), diagnostics);
}

std::optional<Image8> readPng(const std::string& bytes, const std::string& name,
                              Diagnostics& diagnostics) {
  std::string reason;
  const auto header = readPngHeader(bytes, reason);
  if (header && !sizeAllowed(*header, name, diagnostics)) return std::nullopt;
  auto picture = header ? decodePng(bytes, reason) : std::nullopt;
  if (!picture)
    addError(diagnostics, "image-decode", {name}, fmt::format("cannot read the image: {}", reason));
  return picture;
}

bool writePicture(const std::string& path, PictureToWrite picture, Diagnostics& diagnostics) {
  const ImageCodecs* codecs = imageCodecs(path, diagnostics);
  if (!codecs) return false;
  const std::string extension = lowerExtension(path);
  if (!codecs->canWrite(extension)) {
    return addError(diagnostics, "image-format", {path},
                    fmt::format("no image format has the extension \"{}\"", extension),
                    "use .png for display or .exr for linear values");
  }
  picture.storeBytes = storesBytes(path, picture.bytes != nullptr);
  std::optional<std::string> reason;
  const std::error_code error = replaceFile(path, [&](const std::string& partial) {
    reason = codecs->write(partial, extension, picture);
    return !reason;
  });
  return !error ||
         reportUnwritten(path, error, reason.value_or(outputProblem(path)), diagnostics);
}

std::optional<Image8> decodeByModule(const std::string& bytes, const std::string& format,
                                     const std::string& name, Diagnostics& diagnostics) {
  const ImageCodecs* codecs = imageCodecs(name, diagnostics);
  if (!codecs) return std::nullopt;
  std::string reason;
  const auto picture = codecs->open(bytes, format, reason);
  if (!picture) {
    addError(diagnostics, "image-decode", {name}, fmt::format("cannot read the image: {}", reason));
    return std::nullopt;
  }
  if (!isFlat(*picture, name, diagnostics)) return std::nullopt;
  Image8 stored(picture->width, picture->height, picture->channels);
  const auto failure = picture->read(stored.pixels.data());
  if (!failure) return stored;
  addError(diagnostics, "image-decode", {name}, fmt::format("cannot read the image: {}", *failure));
  return std::nullopt;
}

}  // namespace

bool isDisplayFormat(const std::string& path) {
  static constexpr std::array<std::string_view, 5> kEndings{".png", ".jpg", ".jpeg", ".tga", ".bmp"};
  return std::ranges::find(kEndings, lowerExtension(path)) != kEndings.end();
}

std::optional<Image8> decodeImage(const std::string& bytes, const std::string& name,
                                  Diagnostics& diagnostics) {
  const std::string format = formatOf(bytes, name);
  if (format.empty()) {
    addError(diagnostics, "image-format", {name}, "not an image in a known format",
             "use PNG, JPEG, TGA, BMP, HDR or EXR");
    return std::nullopt;
  }
  if (format == "png" && !isWholePng(bytes)) {
    addError(diagnostics, "image-decode", {name}, "cannot read the image: the file is cut short",
             "save the image again");
    return std::nullopt;
  }
  auto stored = format == "png" ? readPng(bytes, name, diagnostics)
                                : decodeByModule(bytes, format, name, diagnostics);
  if (!stored || stored->channels == 4) return stored;
  return toRgba(*stored);
}

std::optional<ImageF> readImage(const std::string& path, Diagnostics& diagnostics) {
  if (auto plain = readPlainPng(path)) return plain;
  const ImageCodecs* codecs = imageCodecs(path, diagnostics);
  if (!codecs) return std::nullopt;
  std::string reason;
  const auto picture = codecs->open(path, reason);
  if (!picture) {
    addError(diagnostics, "image-read", {path}, fmt::format("cannot open the image: {}", reason),
             "give an existing PNG, EXR or other image file");
    return std::nullopt;
  }
  if (!isFlat(*picture, path, diagnostics)) return std::nullopt;
  ImageF image(picture->width, picture->height, picture->channels);
  if (const auto failure = picture->read(image.pixels.data())) {
    addError(diagnostics, "image-read", {path}, fmt::format("cannot read the image: {}", *failure));
    return std::nullopt;
  }
  return image;
}

bool writeImage(const std::string& path, const Image8& image, Diagnostics& diagnostics) {
  if (lowerExtension(path) == ".png") return writePng(path, image, diagnostics);
  return writePicture(path,
                      {.width = image.width,
                       .height = image.height,
                       .channels = image.channels,
                       .bytes = image.pixels.data()},
                      diagnostics);
}

bool writeImage(const std::string& path, const ImageF& image, Diagnostics& diagnostics) {
  return writeImage(path, image, {}, diagnostics);
}

bool writeImage(const std::string& path, const ImageF& image,
                const std::vector<std::string>& channelNames, Diagnostics& diagnostics) {
  if (lowerExtension(path) == ".png") return writePng(path, toBytes(image), diagnostics);
  return writePicture(path,
                      {.width = image.width,
                       .height = image.height,
                       .channels = image.channels,
                       .floats = image.pixels.data(),
                       .channelNames = channelNames},
                      diagnostics);
}

}  // namespace orris
