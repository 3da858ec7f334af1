#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "core/replace_file.h"
#include "image/image.h"
#include "image/image_size.h"

namespace orris {
namespace {

constexpr std::int64_t kMaxFilePixels = std::int64_t(1) << 26;
constexpr int kMaxChannels = 16;

bool fail(Diagnostics& diagnostics, const char* id, const std::string& file, std::string message,
          std::string hint = {}) {
  Diagnostic diagnostic;
  diagnostic.id = id;
  diagnostic.at.file = file;
  diagnostic.message = std::move(message);
  diagnostic.hint = std::move(hint);
  diagnostics.push_back(std::move(diagnostic));
  return false;
}

/// The first line of OpenImageIO's text; its further lines repeat the first.
std::string firstLine(std::string text) {
  if (const size_t end = text.find('\n'); end != std::string::npos) text.resize(end);
  return text.empty() ? "unknown reason" : text;
}

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

/// Walks the chunks to the end mark. libpng would print its own message about a cut file.
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

bool sizeAllowed(const OIIO::ImageSpec& spec, const std::string& name, Diagnostics& diagnostics) {
  const bool allowed = spec.width > 0 && spec.height > 0 && spec.depth <= 1 &&
                       spec.width <= kMaxSide && spec.height <= kMaxSide &&
                       std::int64_t(spec.width) * spec.height <= kMaxFilePixels &&
                       spec.nchannels > 0 && spec.nchannels <= kMaxChannels;
  if (allowed) return true;
  return fail(diagnostics, "image-size", name,
              fmt::format("image of {}x{} with {} channels is outside the limits", spec.width,
                          spec.height, spec.nchannels),
              fmt::format("at most {0}x{0}, {1} pixels in all", kMaxSide, kMaxFilePixels));
}

/// Values as stored: OpenImageIO otherwise multiplies colour by alpha when it reads.
OIIO::ImageSpec asStored() {
  OIIO::ImageSpec config;
  config.attribute("oiio:UnassociatedAlpha", 1);
  return config;
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

/// Integer pixels for formats meant for display, float for the rest.
OIIO::TypeDesc storedType(const std::string& extension, bool fromInteger) {
  static constexpr std::array<std::string_view, 5> kDisplay{".png", ".jpg", ".jpeg", ".tga",
                                                            ".bmp"};
  if (std::find(kDisplay.begin(), kDisplay.end(), extension) != kDisplay.end())
    return OIIO::TypeDesc::UINT8;
  const bool floatOnly = extension == ".exr" || extension == ".pfm" || extension == ".hdr";
  return fromInteger && !floatOnly ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT;
}

bool writeTo(OIIO::ImageOutput& output, const std::string& path, const OIIO::ImageSpec& spec,
             OIIO::TypeDesc type, const void* pixels) {
  return output.open(path, spec) && output.write_image(type, pixels) && output.close();
}

bool writePixels(const std::string& path, int width, int height, int channels, OIIO::TypeDesc type,
                 const void* pixels, const std::vector<std::string>& names,
                 Diagnostics& diagnostics) {
  const std::string extension = lowerExtension(path);
  auto output = OIIO::ImageOutput::create(extension.empty() ? "" : extension.substr(1));
  if (!output) {
    OIIO::geterror();
    return fail(diagnostics, "image-format", path,
                fmt::format("no image format has the extension \"{}\"", extension),
                "use .png for display or .exr for linear values");
  }
  OIIO::ImageSpec spec(width, height, channels,
                       storedType(extension, type == OIIO::TypeDesc::UINT8));
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (!names.empty()) {
    spec.channelnames = names;
    spec.alpha_channel = -1;
  }
  // The OpenEXR writer stamps the present time unless it is given one.
  spec.attribute("DateTime", "1970:01:01 00:00:00");
  if (extension == ".png") spec.erase_attribute("DateTime");

  std::string reason;
  const std::error_code error = replaceFile(path, [&](const std::string& partial) {
    const bool written = writeTo(*output, partial, spec, type, pixels);
    if (!written) reason = firstLine(output->geterror());
    return written;
  });
  if (!error) return true;
  if (reason.empty()) reason = error.message();
  return fail(diagnostics, "image-write", path, fmt::format("cannot write the image: {}", reason),
              "check that the folder exists and is writable");
}

}  // namespace

std::optional<Image8> decodeImage(const std::string& bytes, const std::string& name,
                                  Diagnostics& diagnostics) {
  const std::string format = formatOf(bytes, name);
  if (format.empty()) {
    fail(diagnostics, "image-format", name, "not an image in a known format",
         "use PNG, JPEG, TGA, BMP, HDR or EXR");
    return std::nullopt;
  }
  if (format == "png" && !isWholePng(bytes)) {
    fail(diagnostics, "image-decode", name, "cannot read the image: the file is cut short",
         "save the image again");
    return std::nullopt;
  }
  OIIO::Filesystem::IOMemReader reader(bytes.data(), bytes.size());
  auto input = OIIO::ImageInput::create(format);
  OIIO::ImageSpec spec;
  const bool opened = input && input->supports("ioproxy") && input->set_ioproxy(&reader) &&
                      input->open("memory." + format, spec, asStored());
  if (!opened) {
    fail(diagnostics, "image-decode", name,
         fmt::format("cannot read the image: {}",
                     firstLine(input ? input->geterror() : OIIO::geterror())));
    return std::nullopt;
  }
  if (!sizeAllowed(spec, name, diagnostics)) return std::nullopt;
  Image8 stored(spec.width, spec.height, spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, stored.pixels.data())) {
    fail(diagnostics, "image-decode", name,
         fmt::format("cannot read the image: {}", firstLine(input->geterror())));
    return std::nullopt;
  }
  return spec.nchannels == 4 ? std::move(stored) : toRgba(stored);
}

std::optional<ImageF> readImage(const std::string& path, Diagnostics& diagnostics) {
  const OIIO::ImageSpec config = asStored();
  auto input = OIIO::ImageInput::open(path, &config);
  if (!input) {
    fail(diagnostics, "image-read", path,
         fmt::format("cannot open the image: {}", firstLine(OIIO::geterror())),
         "give an existing PNG, EXR or other image file");
    return std::nullopt;
  }
  const OIIO::ImageSpec spec = input->spec();
  if (!sizeAllowed(spec, path, diagnostics)) return std::nullopt;
  ImageF image(spec.width, spec.height, spec.nchannels);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
    fail(diagnostics, "image-read", path,
         fmt::format("cannot read the image: {}", firstLine(input->geterror())));
    return std::nullopt;
  }
  return image;
}

bool writeImage(const std::string& path, const Image8& image, Diagnostics& diagnostics) {
  return writePixels(path, image.width, image.height, image.channels, OIIO::TypeDesc::UINT8,
                     image.pixels.data(), {}, diagnostics);
}

bool writeImage(const std::string& path, const ImageF& image, Diagnostics& diagnostics) {
  return writePixels(path, image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT,
                     image.pixels.data(), {}, diagnostics);
}

bool writeImage(const std::string& path, const ImageF& image,
                const std::vector<std::string>& channelNames, Diagnostics& diagnostics) {
  return writePixels(path, image.width, image.height, image.channels, OIIO::TypeDesc::FLOAT,
                     image.pixels.data(), channelNames, diagnostics);
}

}  // namespace orris
