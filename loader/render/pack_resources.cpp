#include <orris/render/pack_resources.h>

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include <orris/core/add_diagnostic.h>
#include <orris/core/work_record.h>
#include <orris/gl/functions.h>
#include <orris/image/image.h>

namespace orris {
namespace {

constexpr long long kMostBufferBytes = 1LL << 30;

/// Host texture for a "minecraft:..." path. Contract properties.csv "texture.<stage>.<sampler>".
std::string resourceFor(const std::string& path) {
  const std::string name = path.substr(path.find(':') + 1);
  if (name.starts_with("dynamic/")) return "lightmap";
  if (!name.starts_with("textures/atlas/")) return "white";
  if (name.ends_with("_n.png") || name.ends_with("_n")) return "normals";
  if (name.ends_with("_s.png") || name.ends_with("_s")) return "specular";
  return "atlas";
}

// <path>.mcmeta: {"texture": {"blur": bool, "clamp": bool}}.
void readMeta(const FileSource& source, const std::string& path, BoundTexture& texture) {
  const auto text = source.readResource(path + ".mcmeta");
  if (!text) return;
  const auto json = nlohmann::json::parse(*text, nullptr, false);
  if (!json.is_object()) return;
  const auto meta = json.find("texture");
  if (meta == json.end() || !meta->is_object()) return;
  if (const auto blur = meta->find("blur"); blur != meta->end() && blur->is_boolean())
    texture.linear = blur->get<bool>();
  if (const auto clamp = meta->find("clamp"); clamp != meta->end() && clamp->is_boolean())
    texture.repeat = !clamp->get<bool>();
}

gl::Texture loadPng(const std::string& bytes, const std::string& path, Diagnostics& diagnostics) {
  const auto image = decodeImage(bytes, path, diagnostics);
  if (!image) return {};
  gl::Texture texture =
      gl::createTexture(2, *findFormat("RGBA8"), image->width, image->height, 1, 1, path);
  gl::upload(texture, GL_RGBA, GL_UNSIGNED_BYTE, image->pixels.data());
  return texture;
}

int dimensionsOfRaw(const std::string& type) {
  std::string upper = type;
  std::transform(upper.begin(), upper.end(), upper.begin(),
                 [](unsigned char c) { return std::toupper(c); });
  return upper == "TEXTURE_1D" ? 1 : upper == "TEXTURE_3D" ? 3 : 2;
}

gl::Texture loadRaw(const std::string& bytes, const TextureBinding& b, Diagnostics& diagnostics) {
  const TextureFormat* format = findFormat(b.rawFormat);
  const auto pixelFormat = findPixelFormat(b.pixelFormat);
  const auto pixelType = findPixelType(b.pixelType);
  if (format == nullptr || !pixelFormat || !pixelType) {
    addWarning(diagnostics, "texture-format", b.at,
               fmt::format("unknown format in '{} {} {}'", b.rawFormat, b.pixelFormat, b.pixelType),
               "use names such as RGBA16F RGBA HALF_FLOAT");
    return {};
  }
  const long long needed =
      1LL * b.size[0] * b.size[1] * b.size[2] * componentsOf(*pixelFormat) * pixelType->second;
  if (b.size[0] < 1 || b.size[1] < 1 || b.size[2] < 1 ||
      needed > static_cast<long long>(bytes.size())) {
    addWarning(
        diagnostics, "texture-size", b.at,
        fmt::format("{} has {} bytes, the declared size needs {}", b.path, bytes.size(), needed),
        "correct the size or the file");
    return {};
  }
  gl::Texture texture = gl::createTexture(dimensionsOfRaw(b.rawType), *format, b.size[0], b.size[1],
                                          b.size[2], 1, b.path);
  gl::upload(texture, *pixelFormat, pixelType->first, bytes.data());
  return texture;
}

}  // namespace

PackResources::PackResources(const ShaderPack& pack, int width, int height,
                             Diagnostics& diagnostics) {
  for (const TextureBinding& binding : pack.properties.textures)
    addTexture(pack, binding, diagnostics);
  for (const CustomImage& image : pack.properties.images)
    addImage(image, width, height, diagnostics);
  for (const BufferObject& buffer : pack.properties.bufferObjects)
    addBuffer(pack, buffer, width, height, diagnostics);
}

void PackResources::addTexture(const ShaderPack& pack, const TextureBinding& binding,
                               Diagnostics& diagnostics) {
  BoundTexture bound;
  bound.binding = binding;
  if (binding.path.find(':') != std::string::npos) {
    bound.resource = resourceFor(binding.path);
    textures_.push_back(std::move(bound));
    return;
  }
  const auto bytes = pack.source->readResource(binding.path);
  if (!bytes) {
    addWarning(diagnostics, "texture-missing", binding.at,
               fmt::format("the pack has no file {}", binding.path),
               "add the file or drop the line");
    return;
  }
  const bool raw = !binding.rawType.empty();
  bound.linear = raw;
  bound.repeat = !raw;
  readMeta(*pack.source, binding.path, bound);
  bound.texture =
      raw ? loadRaw(*bytes, binding, diagnostics) : loadPng(*bytes, binding.path, diagnostics);
  if (bound.texture.id() == 0) return;
  gl::setParameters(bound.texture, {.linear = bound.linear, .repeat = bound.repeat});
  textures_.push_back(std::move(bound));
}

void PackResources::addImage(const CustomImage& plan, int width, int height,
                             Diagnostics& diagnostics) {
  ImageResource image;
  image.plan = plan;
  image.format = findFormat(plan.internalFormat);
  if (image.format == nullptr || !image.format->imageLoadStore) {
    addError(diagnostics, "image-format", plan.at,
             fmt::format("image.{}: {} cannot be used for image load and store", plan.name,
                         plan.internalFormat),
             "use a format such as RGBA16F, R32UI or RGBA8");
    return;
  }
  const float window[3] = {static_cast<float>(width), static_cast<float>(height), 1};
  int size[3] = {1, 1, 1};
  for (int i = 0; i < plan.dimensions; ++i)
    size[i] = std::clamp(static_cast<int>(plan.relative ? plan.size[i] * window[i] : plan.size[i]),
                         1, 16384);
  if (1LL * size[0] * size[1] * size[2] * image.format->bytesPerPixel > kMostBufferBytes) {
    addError(diagnostics, "image-size", plan.at,
             fmt::format("image.{} of {}x{}x{} is larger than 1 GiB", plan.name, size[0], size[1],
                         size[2]),
             "make it smaller");
    return;
  }
  image.texture =
      gl::createTexture(plan.dimensions, *image.format, size[0], size[1], size[2], 1, plan.name);
  gl::setParameters(image.texture, {.linear = !image.format->isInteger()});
  images_.push_back(std::move(image));
}

void PackResources::addBuffer(const ShaderPack& pack, const BufferObject& plan, int width,
                              int height, Diagnostics& diagnostics) {
  long long bytes = plan.bytes;
  if (plan.relative)
    bytes *= static_cast<long long>(static_cast<float>(width) * plan.scale[0]) *
             static_cast<long long>(static_cast<float>(height) * plan.scale[1]);
  if (bytes < 1) return;
  std::string contents;
  if (!plan.file.empty())
    if (auto file = pack.source->readResource(plan.file)) contents = std::move(*file);
  if (bytes > kMostBufferBytes || static_cast<long long>(contents.size()) > bytes) {
    addError(diagnostics, "buffer-size", plan.at,
             fmt::format("bufferObject.{} of {} bytes cannot be made", plan.index, bytes),
             "at most 1 GiB, and not less than its file");
    return;
  }
  const std::string name = fmt::format("bufferObject.{}", plan.index);
  noteWork("making", name, plan.at.file);
  gl::Buffer& buffer = buffers_[plan.index] = gl::createBuffer(static_cast<size_t>(bytes), nullptr, name);
  if (gl::GetError() == GL_OUT_OF_MEMORY) {
    addError(diagnostics, "buffer-size", plan.at,
             fmt::format("the driver has no memory for {} of {} bytes", name, bytes), "make it smaller");
    return;
  }
  if (!contents.empty()) gl::upload(buffer, 0, contents.size(), contents.data());
}

const BoundTexture* PackResources::find(const std::string& stage, const std::string& sampler,
                                        int dimensions) const {
  for (const BoundTexture& texture : textures_) {
    const TextureBinding& b = texture.binding;
    if (b.sampler != sampler || (!b.stage.empty() && b.stage != stage)) continue;
    const int own = b.rawType.empty() ? 2 : dimensionsOfRaw(b.rawType);
    if (own == dimensions) return &texture;
  }
  return nullptr;
}

const ImageResource* PackResources::image(const std::string& name) const {
  for (const ImageResource& image : images_)
    if (image.plan.name == name) return &image;
  return nullptr;
}

const ImageResource* PackResources::imageSampler(const std::string& name) const {
  for (const ImageResource& image : images_)
    if (image.plan.sampler == name) return &image;
  return nullptr;
}

void PackResources::bindBuffers() const {
  for (const auto& [index, buffer] : buffers_)
    gl::BindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<unsigned>(index), buffer.id());
}

void PackResources::clearImages(bool all) const {
  for (const ImageResource& image : images_)
    if (all || image.plan.clear)
      gl::ClearTexImage(image.texture.id(), 0, image.format->pixelFormat, image.format->pixelType,
                        nullptr);
}

unsigned PackResources::buffer(int index) const {
  const auto it = buffers_.find(index);
  return it == buffers_.end() ? 0 : it->second.id();
}

}  // namespace orris
