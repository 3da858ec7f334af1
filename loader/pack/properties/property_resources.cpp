// Keys that bring textures, images, buffers and custom uniforms.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include <orris/core/files/pack_path.h>
#include <orris/pack/files/text.h>
#include <orris/pack/properties/property_keys.h>
#include <orris/pack/properties/texture_format.h>

namespace orris {
namespace {

using Words = std::vector<std::string>;

const Words kStages{"setup", "begin", "shadowcomp", "prepare", "gbuffers", "deferred", "composite"};
constexpr size_t kMostImages = 16;
constexpr int kLargestSide = 16384;
constexpr long long kLargestBuffer = 1LL << 30;
constexpr int kLastBufferObject = 12;  // Iris: ShaderProperties; the next ones are its own

/// A pack path, "/../..." beside the shaders folder. "" when it leaves the pack.
std::string filePath(const std::string& written) {
  return resolvePackPath("/shaders.properties", written, AboveRoot::Beside).value_or("");
}

/// A resource ("minecraft:textures/...") or filePath().
std::string resourcePath(const std::string& written) {
  return written.find(':') == std::string::npos ? filePath(written) : written;
}

/// The name in upper case; a warning with the nearest one and "" otherwise.
std::string requireName(const PropertyContext& context, const std::string& word, const char* what,
                        const Words& names) {
  std::string known = knownName(word, names);
  if (known.empty()) {
    const std::string hint = suggest(word, names);
    context.refuse("format-unknown", fmt::format("{} is no {}", word, what),
                   hint.empty() ? fmt::format("known are {}", fmt::join(names, ", ")) : hint, word);
  }
  return known;
}

bool readSides(const PropertyContext& context, const Words& words, size_t first, size_t count,
               std::array<int, 3>& size) {
  for (size_t i = 0; i < count; ++i) {
    const auto side = parseInteger(words[first + i]);
    if (!side) {
      context.refuse("property-value", fmt::format("\"{}\" is no size", words[first + i]),
                     fmt::format("sizes are whole numbers from 1 to {}", kLargestSide),
                     words[first + i]);
      return false;
    }
    if (*side < 1 || *side > kLargestSide) {
      context.warn("property-value", fmt::format("\"{}\" is no size", words[first + i]),
                   fmt::format("sizes are whole numbers from 1 to {}", kLargestSide),
                   words[first + i]);
      return false;
    }
    size[i] = static_cast<int>(*side);
  }
  return true;
}

/// "path TYPE INTERNAL X [Y [Z]] PIXELFORMAT PIXELTYPE"; the number of words says how many sides.
bool readRaw(const PropertyContext& context, const Words& words, TextureBinding& binding) {
  if (words.size() < 6 || words.size() > 8) {
    context.ignore("texture-syntax",
                   fmt::format("{} words after {}, expected a path alone or a raw texture",
                               words.size(), context.entry.key),
                   "raw: path TYPE INTERNAL_FORMAT X [Y [Z]] PIXEL_FORMAT PIXEL_TYPE");
    return false;
  }
  const size_t sides = words.size() - 5;
  binding.rawType = requireName(context, words[1], "texture type", textureTypeNames());
  binding.rawFormat = requireName(context, words[2], "internal format", internalFormatNames());
  binding.pixelFormat = requireName(context, words[3 + sides], "pixel format", pixelFormatNames());
  binding.pixelType = requireName(context, words[4 + sides], "pixel type", pixelTypeNames());
  return !binding.rawType.empty() && !binding.rawFormat.empty() && !binding.pixelFormat.empty() &&
         !binding.pixelType.empty() && readSides(context, words, 3, sides, binding.size);
}

void addTexture(const PropertyContext& context, std::string_view stage, std::string_view sampler) {
  const Words words = splitSingleBlanks(context.entry.value);
  if (words[0].empty()) {
    context.ignore("texture-syntax", fmt::format("{} names no file", context.entry.key));
    return;
  }
  TextureBinding binding{.stage = std::string(stage),
                         .sampler = std::string(sampler),
                         .path = resourcePath(words[0]),
                         .at = context.entry.at};
  if (binding.path.empty()) {
    context.fail("texture-path", fmt::format("{} leads out of the pack", words[0]), "", words[0]);
    return;
  }
  if (words.size() == 1 || readRaw(context, words, binding)) {
    context.out.textures.push_back(std::move(binding));
  }
}

void addUniform(const PropertyContext& context, std::string_view rest, bool uploaded) {
  static const std::array<std::pair<std::string_view, ValueType>, 6> kTypes{
      {{"float", ValueType::Float},
       {"int", ValueType::Int},
       {"bool", ValueType::Bool},
       {"vec2", ValueType::Vec2},
       {"vec3", ValueType::Vec3},
       {"vec4", ValueType::Vec4}}};
  const auto parts = splitAt(rest, '.');
  const auto type =
      std::find_if(kTypes.begin(), kTypes.end(), [&](auto& t) { return t.first == parts[0]; });
  if (parts.size() != 2 || parts[1].empty() || type == kTypes.end()) {
    context.ignore(
        "uniform-syntax", fmt::format("{} is no custom uniform", context.entry.key),
        "write uniform.TYPE.NAME or variable.TYPE.NAME with TYPE float, int, bool, vec2, "
        "vec3 or vec4");
    return;
  }
  auto& uniforms = context.out.customUniforms;
  const auto same =
      std::find_if(uniforms.begin(), uniforms.end(), [&](auto& u) { return u.name == parts[1]; });
  if (same != uniforms.end()) {
    context.ignore("uniform-duplicate",
                   fmt::format("{} is already defined in line {}", parts[1], same->at.line));
    return;
  }
  uniforms.push_back({.name = std::string(parts[1]),
                      .type = type->second,
                      .uploaded = uploaded,
                      .expression = context.entry.value,
                      .at = context.entry.at,
                      .lines = context.entry.lines});
}

/// The window factors or texel counts after the six fixed words of an image.
bool readImageSize(const PropertyContext& context, const Words& words, CustomImage& image) {
  image.dimensions = image.relative ? 2 : static_cast<int>(words.size()) - 6;
  if (!image.relative) {
    std::array<int, 3> size{1, 1, 1};
    if (!readSides(context, words, 6, words.size() - 6, size)) return false;
    std::copy(size.begin(), size.end(), image.size.begin());
    return true;
  }
  constexpr const char* kFactors = "a relative image needs two positive factors of the window size";
  for (size_t i = 0; i < 2; ++i) {
    const auto factor = parseFloat(words[6 + i]);
    if (!factor) {
      context.refuse("image-syntax", kFactors);
      return false;
    }
    if (*factor <= 0 || *factor > 64) {
      context.warn("image-syntax", kFactors);
      return false;
    }
    image.size[i] = *factor;
  }
  return true;
}

bool isTrue(const std::string& word) { return lowerCase(word) == "true"; }

/// Are there enough words for an image, but not too many?
bool hasImageWords(const PropertyContext& context, const Words& words) {
  const bool relative = words.size() > 5 && isTrue(words[5]);
  if (relative ? words.size() > 7 : words.size() > 6 && words.size() < 10) return true;
  const std::string message = fmt::format("{} words after {}", words.size(), context.entry.key);
  constexpr const char* kForm =
      "write SAMPLER|none FORMAT INTERNAL_FORMAT PIXEL_TYPE CLEAR RELATIVE X [Y [Z]]";
  if (relative || words.size() < 6) {
    context.refuse("image-syntax", message, kForm);
  } else {
    context.ignore("image-syntax", message, kForm);
  }
  return false;
}

}  // namespace

void readTexture(const PropertyContext& context, std::string_view rest) {
  if (rest == "noise") return addTexture(context, "", "noisetex");
  const auto parts = splitAt(rest, '.');
  if (parts.size() < 2) {
    context.refuse("texture-syntax", fmt::format("{} names no sampler", context.entry.key),
                   "write texture.<stage>.<sampler>=<path>");
    return;
  }
  if (std::find(kStages.begin(), kStages.end(), parts[0]) == kStages.end()) {
    context.ignore("texture-stage", fmt::format("texture stage {} is unknown", parts[0]),
                   fmt::format("stages are {}", fmt::join(kStages, ", ")));
    return;
  }
  if (parts[1].empty()) {
    context.warn("texture-syntax", fmt::format("{} names no sampler", context.entry.key));
    return;
  }
  addTexture(context, parts[0], parts[1]);
}

void readCustomTexture(const PropertyContext& context, std::string_view sampler) {
  addTexture(context, "", sampler);
}

void readImage(const PropertyContext& context, std::string_view name) {
  const Words words = splitSingleBlanks(context.entry.value);
  if (!hasImageWords(context, words)) return;
  if (context.out.images.size() == kMostImages) {
    context.ignore("image-limit", fmt::format("only {} images are possible", kMostImages), "",
                   name);
    return;
  }
  CustomImage image{
      .name = std::string(name),
      .sampler = words[0] == "none" ? "" : words[0],
      .pixelFormat = requireName(context, words[1], "pixel format", pixelFormatNames()),
      .internalFormat = requireName(context, words[2], "internal format", internalFormatNames()),
      .pixelType = requireName(context, words[3], "pixel type", pixelTypeNames()),
      .clear = isTrue(words[4]),
      .relative = isTrue(words[5]),
      .at = context.entry.at};
  if (image.pixelFormat.empty() || image.internalFormat.empty() || image.pixelType.empty()) return;
  if (readImageSize(context, words, image)) context.out.images.push_back(std::move(image));
}

void readBufferObject(const PropertyContext& context, std::string_view index) {
  const Words words = splitSingleBlanks(context.entry.value);
  const auto number = parseInteger(index);
  const auto bytes = words.empty() ? std::nullopt : parseInteger(words[0]);
  const bool known = number && *number >= 0 && *number <= kLastBufferObject;
  if (!known || !bytes || *bytes > kLargestBuffer || words.size() == 3) {
    context.ignore(
        "buffer-object-syntax",
        fmt::format("{} = {} is no buffer object", context.entry.key, context.entry.value),
        fmt::format("write bufferObject.0 to .{} = BYTES, BYTES FILE or BYTES RELATIVE X "
                    "Y; at most {} bytes",
                    kLastBufferObject, kLargestBuffer));
    return;
  }
  if (*bytes < 1) return;  // how packs switch a buffer off
  BufferObject buffer{.index = static_cast<int>(*number), .bytes = *bytes, .at = context.entry.at};
  if (words.size() == 2) {
    buffer.file = filePath(words[1]);
    if (buffer.file.empty()) {
      context.fail("texture-path", fmt::format("{} leads out of the pack", words[1]), "", words[1]);
      return;
    }
  } else if (words.size() > 3) {
    const auto x = parseFloat(words[2]), y = parseFloat(words[3]);
    buffer.relative = isTrue(words[1]);
    if (!x || !y || (buffer.relative && (*x <= 0 || *y <= 0))) {
      context.warn("buffer-object-syntax",
                   "a relative buffer needs two positive factors of the window size");
      return;
    }
    if (buffer.relative) buffer.scale = {*x, *y};
  }
  context.out.bufferObjects.push_back(std::move(buffer));
}

void readUniform(const PropertyContext& context, std::string_view rest) {
  addUniform(context, rest, true);
}

void readVariable(const PropertyContext& context, std::string_view rest) {
  addUniform(context, rest, false);
}

}  // namespace orris
