#include <orris/check/pack/directive_checks.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include <orris/check/pack/pack_texts.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

/// Contract: constants.csv. More buffers than this host has, for packs that are written for others.
std::set<std::string, std::less<>> makeDirectiveNames() {
  constexpr int kColorBuffers = 32, kShadowBuffers = 8;
  std::set<std::string, std::less<>> names{"shadowMapResolution",
                                           "shadowDistance",
                                           "shadowDistanceRenderMul",
                                           "entityShadowDistanceMul",
                                           "shadowIntervalSize",
                                           "shadowMapFov",
                                           "shadowNearPlane",
                                           "shadowFarPlane",
                                           "voxelDistance",
                                           "sunPathRotation",
                                           "ambientOcclusionLevel",
                                           "noiseTextureResolution",
                                           "wetnessHalflife",
                                           "drynessHalflife",
                                           "eyeBrightnessHalflife",
                                           "centerDepthHalflife",
                                           "shadowHardwareFiltering",
                                           "generateShadowMipmap",
                                           "generateShadowColorMipmap",
                                           "shadowtexMipmap",
                                           "shadowtexNearest",
                                           "superSamplingLevel",
                                           "workGroups",
                                           "workGroupsRender",
                                           "countInstances",
                                           "maxVerticesOut"};
  const auto add = [&](const std::string& buffer, std::initializer_list<const char*> suffixes) {
    for (const char* suffix : suffixes) names.insert(buffer + suffix);
  };
  for (const char* legacy :
       {"gcolor", "gdepth", "gnormal", "composite", "gaux1", "gaux2", "gaux3", "gaux4"}) {
    add(legacy, {"Format", "Clear", "ClearColor", "MipmapEnabled"});
  }
  for (int i = 0; i < kColorBuffers; ++i) {
    add(fmt::format("colortex{}", i), {"Format", "Clear", "ClearColor", "MipmapEnabled"});
  }
  for (int i = 0; i < kShadowBuffers; ++i) {
    add(fmt::format("shadowHardwareFiltering{}", i), {""});
    add(fmt::format("shadowtex{}", i), {"Mipmap", "Nearest", "MinMagNearest"});
    add(fmt::format("shadow{}", i), {"MinMagNearest"});
    for (const char* prefix : {"shadowcolor", "shadowColor"}) {
      add(fmt::format("{}{}", prefix, i),
          {"Format", "Clear", "ClearColor", "Mipmap", "Nearest", "MinMagNearest"});
    }
  }
  return names;
}

const std::set<std::string, std::less<>>& directiveNames() {
  static const auto kNames = makeDirectiveNames();
  return kNames;
}

/// The name on a line like "const int colortex1Format = RGBA16F;"; "" when it is none.
std::string_view constName(std::string_view line) {
  const auto skipWord = [&](std::string_view word) {
    if (!line.starts_with(word) || word.empty()) return false;
    line.remove_prefix(word.size());
    const size_t blanks = std::min(line.find_first_not_of(" \t"), line.size());
    line.remove_prefix(blanks);
    return blanks > 0;
  };
  line = trim(line);
  if (!skipWord("const") || !skipWord(leadingWord(line))) return "";
  return leadingWord(line);
}

struct NearlyDirective {
  SourceLocation at;
  std::string sourceLine, meant;
};

/// Constants whose names are nearly those of directives: by name, their lines.
std::map<std::string, std::vector<NearlyDirective>> nearlyDirectives(const ShaderPack& pack,
                                                                     AuthorLines& lines) {
  const auto& known = directiveNames();
  const std::vector<std::string> names(known.begin(), known.end());
  std::map<std::string, std::string> meant;
  std::map<std::string, std::vector<NearlyDirective>> found;
  for (const auto& [file, ignored] : pack.files) {
    const FileLines& text = lines.file(file);
    for (size_t i = 0; i < text.size(); ++i) {
      const std::string name(constName(text[i]));
      if (name.empty() || known.contains(name)) continue;
      const auto [nearest, isNew] = meant.try_emplace(name);
      if (isNew) nearest->second = likelyMeant(name, names);
      // A constant made from the directive is the pack's own.
      if (nearest->second.empty() || text[i].find(nearest->second) != std::string::npos) continue;
      const int column = static_cast<int>(text[i].find(name)) + 1;
      found[name].push_back({{file, static_cast<int>(i) + 1, column}, text[i], nearest->second});
    }
  }
  return found;
}

/// How often each of the names occurs as a word in the pack.
std::map<std::string, size_t, std::less<>> countWords(
    const ShaderPack& pack, const std::map<std::string, std::vector<NearlyDirective>>& names,
    AuthorLines& lines) {
  std::map<std::string, size_t, std::less<>> counts;
  for (const auto& entry : names) counts[entry.first] = 0;
  for (const auto& entry : pack.files) {
    for (const std::string& line : lines.file(entry.first)) {
      forEachWord(line, [&](std::string_view word) {
        const auto found = counts.find(word);
        if (found != counts.end()) ++found->second;
      });
    }
  }
  return counts;
}

void report(const NearlyDirective& candidate, const std::string& name, Diagnostics& diagnostics) {
  std::string repaired = candidate.sourceLine;
  repaired.replace(std::size_t(candidate.at.column - 1), name.size(), candidate.meant);
  diagnostics.push_back({.severity = Severity::Warning,
                         .id = "directive-misspelt",
                         .at = candidate.at,
                         .message = fmt::format("nothing reads {}, which is no directive", name),
                         .sourceLine = candidate.sourceLine,
                         .hint = fmt::format("did you mean {}?", candidate.meant),
                         .repair = LineEdit{candidate.at.file, candidate.at.line, repaired, true}});
}

/// "/* RENDERTAGETS: 0,3 */" on one line.
void checkComment(const std::string& file, size_t index, const std::string& line,
                  Diagnostics& diagnostics) {
  static const std::vector<std::string> kComments{"RENDERTARGETS", "DRAWBUFFERS"};
  static const std::regex kForm(R"(/\*\s*([A-Za-z_]{6,20})\s*:\s*[0-9][0-9,\s]*\*/)");
  constexpr size_t kLongest = 1000;  // std::regex recurses
  if (line.size() > kLongest || line.find("/*") == std::string::npos) return;
  std::smatch match;
  if (!std::regex_search(line, match, kForm)) return;
  const std::string name = match[1];
  const std::string meant = likelyMeant(name, kComments);
  if (meant.empty() || meant == name) return;
  const int column = static_cast<int>(match.position(1)) + 1;
  report({{file, static_cast<int>(index) + 1, column}, line, meant}, name, diagnostics);
}

}  // namespace

void checkDirectiveNames(std::span<const ShaderPack> folders, Diagnostics& diagnostics) {
  const ShaderPack& pack = folders.front();
  AuthorLines lines(pack);
  const auto nearly = nearlyDirectives(pack, lines);
  if (!nearly.empty()) {
    const auto counts = countWords(pack, nearly, lines);
    for (const auto& [name, candidates] : nearly) {
      // What the shader uses itself is its own constant.
      if (counts.at(name) > candidates.size()) continue;
      for (const NearlyDirective& candidate : candidates) report(candidate, name, diagnostics);
    }
  }
  for (const auto& entry : pack.files) {
    const FileLines& text = lines.file(entry.first);
    for (size_t i = 0; i < text.size(); ++i) checkComment(entry.first, i, text[i], diagnostics);
  }
}

}  // namespace orris
