#include <orris/world/resources/texture_files.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/world/resources/texture_meta.h>

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

/// A texture's colours and maps as they lie in the files.
struct Strips {
  Image8 albedo;
  std::optional<Image8> normal, specular;  // of the size of `albedo`: one for each frame
  std::optional<Image8> flatNormal, flatSpecular;  // one for all frames
};

void readMap(const ResourceStack& resources, const ResourceName& name, const Image8& whole,
             std::optional<Image8>& strip, std::optional<Image8>& flat, Diagnostics& diagnostics) {
  auto map = readPicture(resources, name, diagnostics);
  if (!map) return;
  if (map->width * whole.height == map->height * whole.width)
    strip = resized(*map, whole.width, whole.height);
  else
    flat = std::move(map);
}

/// LabPBR's defaults; those that Iris takes.
constexpr std::array<std::uint8_t, 4> kFlatNormal{127, 127, 255, 255}, kDull{0, 0, 0, 0};

Image8 mapOf(const std::optional<Image8>& strip, const std::optional<Image8>& flat,
             const FramePart& part, const Image8& frame, std::array<std::uint8_t, 4> otherwise) {
  if (strip) return cut(*strip, part);
  return flat ? resized(*flat, frame.width, frame.height) : filled(frame, otherwise);
}

/// Each frame that the steps name once; the steps then count these.
TileAnimation animationOf(const Strips& strips, const TextureMeta& meta) {
  TileAnimation animation;
  animation.interpolate = meta.interpolate;
  std::map<int, int> places;
  for (AnimationStep step : meta.steps) {
    const auto [place, fresh] = places.try_emplace(step.frame, int(places.size()));
    if (fresh) {
      const FramePart part{meta.width, meta.height, step.frame};
      TileImages& frame = animation.frames.emplace_back();
      frame.albedo = cut(strips.albedo, part);
      if (strips.normal) frame.normal = cut(*strips.normal, part);
      if (strips.specular) frame.specular = cut(*strips.specular, part);
    }
    step.frame = place->second;
    animation.steps.push_back(step);
  }
  return animation;
}

std::size_t texelsOf(const TextureMeta& meta) {
  std::set<int> frames;
  for (const AnimationStep& step : meta.steps) frames.insert(step.frame);
  return frames.size() * std::size_t(meta.width) * std::size_t(meta.height);
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

std::optional<PackTexture> readTexture(const ResourceStack& resources, const ResourceName& name,
                                       AnimationBudget& budget, Diagnostics& diagnostics) {
  auto whole = readPicture(resources, name, diagnostics);
  if (!whole) return std::nullopt;
  const auto file = resources.read(name, kTextureMeta, diagnostics);
  const auto meta =
      file ? parseTextureMeta(*file, {whole->width, whole->height}, diagnostics) : std::nullopt;
  Strips strips{*std::move(whole), {}, {}, {}, {}};
  readMap(resources, {name.space, name.path + "_n"}, strips.albedo, strips.normal,
          strips.flatNormal, diagnostics);
  readMap(resources, {name.space, name.path + "_s"}, strips.albedo, strips.specular,
          strips.flatSpecular, diagnostics);
  FramePart part{strips.albedo.width, strips.albedo.height, 0};
  if (meta) part = {meta->width, meta->height, meta->steps.front().frame};
  PackTexture texture;
  texture.images.albedo = cut(strips.albedo, part);
  texture.images.normal =
      mapOf(strips.normal, strips.flatNormal, part, texture.images.albedo, kFlatNormal);
  texture.images.specular =
      mapOf(strips.specular, strips.flatSpecular, part, texture.images.albedo, kDull);
  if (!meta || meta->steps.size() < 2) return texture;
  if (texelsOf(*meta) > budget.texels) {
    ++budget.refused;
    return texture;
  }
  budget.texels -= texelsOf(*meta);
  texture.animation = animationOf(strips, *meta);
  return texture;
}

}  // namespace orris
