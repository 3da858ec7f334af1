#include "pack/program_builder.h"

#include <algorithm>
#include <atomic>
#include <set>
#include <thread>

#include "pack/mods.h"
#include "pack/text.h"

namespace orris {
namespace {

constexpr const char* kDefaultVertexFile = "(default vertex shader)";
constexpr const char* kDefaultVertexShader = R"(#version 120
varying vec4 hostTexCoord[3];
varying vec4 hostColor;
void main() {
  gl_Position = ftransform();
  hostTexCoord[0] = gl_TextureMatrix[0] * gl_MultiTexCoord0;
  hostTexCoord[1] = gl_TextureMatrix[1] * gl_MultiTexCoord1;
  hostTexCoord[2] = gl_TextureMatrix[1] * gl_MultiTexCoord2;
  hostColor = gl_Color;
})";

FlatSource defaultVertexSource() {
  FlatSource flat;
  flat.sites.push_back({kDefaultVertexFile});
  for (std::string& line : splitLines(kDefaultVertexShader)) {
    flat.lines.push_back({std::move(line), 0, static_cast<int>(flat.lines.size()) + 1});
  }
  return flat;
}

bool drawsShadow(const ProgramFile& program) {
  if (modFamilyOf(program.group)) return program.program.find("_shadow") != std::string::npos;
  return program.group == ProgramGroup::Shadow || program.group == ProgramGroup::ShadowComp;
}

/// Number of buffers that the program can draw to.
int targetsOf(const ProgramFile& program) {
  return drawsShadow(program) ? kShadowColorTargets : kColorTargets;
}

/// "local_size_x = 8" in a compute shader; sizes that are no literal stay 1.
std::array<int, 3> readLocalSize(const std::vector<Token>& tokens) {
  std::array<int, 3> size{1, 1, 1};
  for (size_t i = 0; i + 2 < tokens.size(); ++i) {
    const std::string& name = tokens[i].text;
    if (!name.starts_with("local_size_") || name.size() != 12 || tokens[i + 1].text != "=")
      continue;
    const auto value = parseInteger(tokens[i + 2].text);
    const int axis = name.back() - 'x';
    if (value && *value > 0 && *value <= 4096 && axis >= 0 && axis < 3) {
      size[static_cast<size_t>(axis)] = static_cast<int>(*value);
    }
  }
  return size;
}

class ProgramBuild {
 public:
  ProgramBuild(const ProgramEntry& entry, const BuildContext& context)
      : entry_(entry), context_(context) {}

  BuiltProgram run() {
    ProgramSource& source = built_.source;
    source.name = entry_.name.program;
    source.folder = entry_.name.folder;
    source.group = entry_.name.group;
    source.index = entry_.name.index;
    for (const auto& [stage, file] : entry_.stages) addStage(stage, file);
    for (const auto& [name, file] : entry_.computes) addCompute(name, file);
    applyProperties();
    source.options.assign(options_.begin(), options_.end());
    source.hash = hash_;
    return std::move(built_);
  }

 private:
  TokenStream preprocessFile(const std::string& file) {
    if (file.empty()) return preprocess(defaultVertexSource(), context_.macros, built_.diagnostics);
    for (const std::string& reached : reachableFiles(context_.graph, file)) {
      const auto mentioned = context_.mentions.find(reached);
      if (mentioned != context_.mentions.end()) {
        options_.insert(mentioned->second.begin(), mentioned->second.end());
      }
    }
    const FlatSource flat = flatten(context_.graph, context_.files, file, built_.diagnostics);
    TokenStream stream = preprocess(flat, context_.macros, built_.diagnostics);
    requireVersion(stream, built_.diagnostics);
    return stream;
  }

  void addStage(Stage stage, const std::string& file) {
    TokenStream stream = preprocessFile(file);
    if (stage == Stage::Fragment) {
      built_.source.directives =
          readProgramDirectives(stream, targetsOf(entry_.name), built_.diagnostics);
      built_.constLines = findConstLines(stream);
      built_.sites = stream.sites;
    }
    RewriteResult result = rewrite(stream, stage, context_.names);
    built_.source.writesFragData |= result.writesFragData;
    addRules(result.rules);
    built_.source.stages.push_back({stage, print(stream)});
    addToHash(stageName(stage), built_.source.stages.back().text.text);
  }

  void addCompute(const std::string& name, const std::string& file) {
    TokenStream stream = preprocessFile(file);
    ComputeSource compute{.name = name};
    compute.directives = readProgramDirectives(stream, kColorTargets, built_.diagnostics);
    compute.localSize = readLocalSize(stream.tokens);
    compute.rules = rewrite(stream, Stage::Compute).rules;
    compute.text = {Stage::Compute, print(stream)};
    addToHash(name, compute.text.text.text);
    built_.source.computes.push_back(std::move(compute));
  }

  void addRules(const std::vector<AppliedRule>& rules) {
    for (const AppliedRule& rule : rules) {
      auto& all = built_.source.rules;
      const auto same =
          std::find_if(all.begin(), all.end(), [&](auto& r) { return r.rule == rule.rule; });
      if (same == all.end()) {
        all.push_back(rule);
      } else {
        same->count += rule.count;
      }
    }
  }

  void addToHash(std::string_view name, std::string_view text) {
    // FNV-1a, with the lengths so that texts cannot run into each other.
    const auto add = [&](unsigned char byte) { hash_ = (hash_ ^ byte) * 0x100000001b3ULL; };
    for (const std::string_view part : {name, text}) {
      for (size_t length = part.size(); length > 0; length >>= 8)
        add(static_cast<unsigned char>(length));
      for (const char c : part) add(static_cast<unsigned char>(c));
    }
  }

  template <typename Map>
  const typename Map::mapped_type* property(const Map& map) const {
    const auto found = map.find(entry_.name.program);
    return found == map.end() ? nullptr : &found->second;
  }

  void applyProperties() {
    ProgramSource& source = built_.source;
    const ShaderProperties& properties = context_.properties;
    source.drawBuffers = source.directives.drawBuffers.value_or(
        drawsShadow(entry_.name) ? std::vector{0, 1} : std::vector{0});
    if (const auto* test = property(properties.alphaTest)) source.alphaTest = *test;
    if (const auto* blend = property(properties.blend)) source.blend = *blend;
    if (const auto* blends = property(properties.bufferBlend)) source.bufferBlend = *blends;
    if (const auto* scale = property(properties.scale)) source.scale = *scale;
    if (const auto* flips = property(properties.flip)) source.flips = *flips;
  }

  const ProgramEntry& entry_;
  const BuildContext& context_;
  BuiltProgram built_;
  std::set<std::string> options_;
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace

std::vector<BuiltProgram> buildPrograms(const std::vector<ProgramEntry>& entries,
                                        const BuildContext& context) {
  std::vector<BuiltProgram> built(entries.size());
  std::atomic<size_t> next = 0;
  const auto work = [&] {
    for (size_t i = next++; i < entries.size(); i = next++) {
      built[i] = ProgramBuild(entries[i], context).run();
    }
  };
  std::jthread second(work);
  work();
  second.join();
  return built;
}

Mentions findMentions(const std::map<std::string, FileLines>& files, const OptionSet& options) {
  Mentions mentions;
  for (const auto& [file, lines] : files) {
    std::set<std::string> names;
    for (const std::string_view line : lines) {
      for (size_t at = 0; at < line.size();) {
        const std::string_view word = leadingWord(line.substr(at));
        if (!word.empty() && options.find(word)) names.emplace(word);
        at += std::max<size_t>(word.size(), 1);
      }
    }
    if (!names.empty()) mentions[file].assign(names.begin(), names.end());
  }
  return mentions;
}

}  // namespace orris
