#include "world/resources/texture_files.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "core/add_diagnostic.h"
#include "core/limits.h"
#include "world/files/json_reader.h"

namespace orris {
namespace {

constexpr std::size_t kHeaderBytes = 24;  // of a PNG, up to the height

std::uint32_t headerNumber(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = at; i < at + 4; ++i) value = value << 8 | std::uint8_t(bytes[i]);
  return value;
}

/// What the header promises, before anything is allocated for it; "" when it may be decoded.
std::string problemOfHeader(const std::string& bytes) {
  if (bytes.size() < kHeaderBytes || !bytes.starts_with("\x89PNG\r\n\x1a\n"))
    return "this is no PNG";
  const std::uint64_t width = headerNumber(bytes, 16), height = headerNumber(bytes, 20);
  if (width * height > limits::kTextureTexels)
    return fmt::format("the texture has {}x{} texels: expected at most {} in all", width, height,
                       limits::kTextureTexels);
  return "";
}

/// Where one frame of an animation is, in texels.
struct FramePart {
  int width = 0, height = 0;
  int index = 0;  ///< counted along rows
};

/// The game's: a square unless the file says otherwise, and the first of the frames that it lists.
FramePart firstFrame(const JsonNode& animation, const Image8& image, JsonReader& reader) {
  const int side = std::min(image.width, image.height);
  const IntegerRange sides{1, 1 << 15}, frames{0, 1 << 15};
  int width = 0, height = 0;
  reader.optional(animation, "width", sides, width);
  reader.optional(animation, "height", sides, height);
  FramePart part;
  part.width = width > 0 ? width : height > 0 ? image.width : side;
  part.height = height > 0 ? height : width > 0 ? image.height : side;
  const JsonNode* list = animation.find("frames");
  if (!list || !reader.array(*list, "\"frames\"") || list->items.empty()) return part;
  const JsonNode& first = list->items.front();
  const JsonNode* index = first.find("index");
  part.index = reader.integer(index ? *index : first, "a frame", frames).value_or(0);
  return part;
}

std::optional<FramePart> readAnimation(const ResourceStack& resources, const ResourceName& name,
                                       const Image8& image, Diagnostics& diagnostics) {
  const auto meta = resources.read(name, kTextureMeta, diagnostics);
  if (!meta) return std::nullopt;
  const JsonText source{meta->bytes, meta->place, &kResourceJson};
  JsonReader reader(source, diagnostics);
  const auto root = parseLocatedJson(source, diagnostics);
  const JsonNode* animation = root ? root->find("animation") : nullptr;
  if (!animation) return std::nullopt;
  const FramePart part = firstFrame(*animation, image, reader);
  const int columns = image.width / part.width, rows = image.height / part.height;
  if (part.index < columns * rows) return part;
  reader.error(
      animation->offset,
      fmt::format("the animation begins with frame {} of {}x{} texels, but the texture has {}x{}",
                  part.index, part.width, part.height, image.width, image.height));
  return std::nullopt;
}

Image8 cut(const Image8& image, int left, int top, int width, int height) {
  Image8 part(width, height, 4);
  for (int y = 0; y < height; ++y)
    std::copy_n(image.at(left, top + y), std::size_t(width) * 4, part.at(0, y));
  return part;
}

Image8 cut(const Image8& image, const FramePart& part) {
  const int columns = std::max(1, image.width / part.width);
  return cut(image, part.index % columns * part.width, part.index / columns * part.height,
             part.width, part.height);
}

Image8 resized(const Image8& image, int width, int height) {
  if (image.width == width && image.height == height) return image;
  Image8 result(width, height, 4);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      std::copy_n(image.at(x * image.width / width, y * image.height / height), 4, result.at(x, y));
  return result;
}

Image8 filled(const Image8& like, std::array<std::uint8_t, 4> texel) {
  Image8 image(like.width, like.height, 4);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = texel[i % 4];
  return image;
}

/// The map beside a texture, its frame and size; `otherwise` where no pack has one.
Image8 readMap(const ResourceStack& resources, const ResourceName& name, const Image8& whole,
               const FramePart& part, const Image8& frame, std::array<std::uint8_t, 4> otherwise,
               Diagnostics& diagnostics) {
  const auto map = readPicture(resources, name, diagnostics);
  if (!map) return filled(frame, otherwise);
  // A map of one frame serves all of them.
  const bool strip = map->width * whole.height == map->height * whole.width;
  if (!strip) return resized(*map, frame.width, frame.height);
  const Image8 same = resized(*map, whole.width, whole.height);
  return cut(same, part);
}

}  // namespace

std::optional<Image8> readPicture(const ResourceStack& resources, const ResourceName& name,
                                  Diagnostics& diagnostics) {
  const auto file = resources.read(name, kTextures, diagnostics);
  if (!file) return std::nullopt;
  if (std::string problem = problemOfHeader(file->bytes); !problem.empty()) {
    addWarning(diagnostics, "resource-texture", {file->place}, std::move(problem));
    return std::nullopt;
  }
  Diagnostics problems;
  auto image = decodeImage(file->bytes, file->place, problems);
  for (const Diagnostic& problem : problems)
    addWarning(diagnostics, "resource-texture", {file->place}, problem.message);
  return image;
}

std::optional<TileImages> readTexture(const ResourceStack& resources, const ResourceName& name,
                                      Diagnostics& diagnostics) {
  const auto whole = readPicture(resources, name, diagnostics);
  if (!whole) return std::nullopt;
  const FramePart part = readAnimation(resources, name, *whole, diagnostics)
                             .value_or(FramePart{whole->width, whole->height, 0});
  TileImages texture;
  texture.albedo = cut(*whole, part);
  const auto map = [&](const char* suffix, std::array<std::uint8_t, 4> otherwise) {
    return readMap(resources, {name.space, name.path + suffix}, *whole, part, texture.albedo,
                   otherwise, diagnostics);
  };
  // LabPBR's defaults; those that Iris takes.
  texture.normal = map("_n", {127, 127, 255, 255});
  texture.specular = map("_s", {0, 0, 0, 0});
  return texture;
}

}  // namespace orris
