#include <orris/check/frame/texture_checks.h>

#include <fmt/format.h>

#include <set>
#include <string>
#include <string_view>

#include <orris/check/compile/program_text.h>
#include <orris/check/frame/buffer_mentions.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using WordSet = std::set<std::string, std::less<>>;

/// Those of `wanted` that stand in some shader text, whatever the branch or option.
WordSet wordsFound(const ShaderPack& pack, const WordSet& wanted) {
  WordSet found;
  for (const std::string& file : pack.source->files()) {
    if (!isShaderText(file)) continue;
    const auto text = pack.source->read(file);
    if (!text) continue;
    const std::string_view all = *text;
    for (size_t at = 0; at < all.size();) {
      const std::string_view word = leadingWord(all.substr(at));
      if (wanted.contains(word)) found.emplace(word);
      at += std::max<size_t>(word.size(), 1);
    }
  }
  return found;
}

}  // namespace

void checkTexturesUsed(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  if (folders.empty() || !folders.front().source) return;
  const ShaderPack& pack = folders.front();
  WordSet wanted;
  for (const TextureBinding& texture : pack.properties.textures) wanted.insert(texture.sampler);
  for (const CustomImage& image : pack.properties.images) {
    wanted.insert(image.name);
    wanted.insert(image.sampler);
  }
  if (wanted.empty()) return;
  const WordSet found = wordsFound(pack, wanted);
  for (const TextureBinding& texture : pack.properties.textures) {
    if (found.contains(texture.sampler)) continue;
    diagnostics.push_back(
        diagnosticAt(pack, Severity::Note, "texture-unused", texture.at,
                     fmt::format("no program declares the sampler {}", texture.sampler),
                     "the texture is loaded and never read"));
  }
  for (const CustomImage& image : pack.properties.images) {
    if (found.contains(image.name) || found.contains(image.sampler)) continue;
    diagnostics.push_back(diagnosticAt(pack, Severity::Note, "image-unused", image.at,
                                       fmt::format("no program declares the image {}", image.name),
                                       "the image is made and never touched"));
  }
}

}  // namespace orris
