#include <orris/pack/programs/program_builder.h>

#include <algorithm>

#include <orris/glsl/syntax/stage_size.h>
#include <orris/glsl/syntax/struct_size.h>
#include <orris/pack/files/reserved_names.h>
#include <orris/pack/files/text.h>
#include <orris/pack/mods/mods.h>
#include <orris/pack/mods/voxy.h>
#include <orris/pack/programs/attribute_types.h>

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
    flat.own(std::move(line), 0, static_cast<int>(flat.lines.size()) + 1);
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
      : entry_(entry), context_(context), watch_(context.optionNames) {
    names_.assign(context.names.begin(), context.names.end());
    for (const LiveUniform& live : context.live) names_.push_back({live.name, live.declaration});
  }

  ProgramSource run(std::vector<PreprocessedPart> parts) {
    ProgramSource& source = built_;
    source.name = entry_.name.program;
    source.folder = entry_.name.folder;
    source.group = entry_.name.group;
    source.index = entry_.name.index;
    for (PreprocessedPart& part : parts) addUses(part.optionUses);
    std::size_t next = 0;
    for (const auto& [stage, file] : entry_.stages) addStage(stage, parts[next++]);
    for (const auto& [name, file] : entry_.computes) addCompute(name, parts[next++]);
    applyProperties();
    source.options = watch_.used();
    source.conditionOptions = watch_.used(NameWatch::kCondition);
    source.hash = hash_;
    return std::move(built_);
  }

 private:
  void addUses(const std::vector<unsigned char>& uses) {
    for (std::size_t i = 0; i < uses.size(); ++i) watch_.uses[i] |= uses[i];
  }

  std::span<const HostName> liveNames() const {
    return std::span(names_).last(context_.live.size());
  }

  TokenStream& take(PreprocessedPart& part) {
    auto& all = built_.diagnostics;
    all.insert(all.end(), part.diagnostics.begin(), part.diagnostics.end());
    const ProgramGroup group = entry_.name.group;
    if (group != ProgramGroup::Colorwheel && group != ProgramGroup::Voxy)
      checkReservedNames(part.stream, all);
    checkStructSizes(part.stream, all);
    checkStageSize(part.stream, all);
    return part.stream;
  }

  void addStage(Stage stage, PreprocessedPart& part) {
    TokenStream& stream = take(part);
    if (stage == Stage::Fragment) {
      built_.directives = readProgramDirectives(stream, targetsOf(entry_.name), built_.diagnostics);
      built_.constLines = findConstLines(stream);
      built_.constSites = stream.sites;
      watchConstLines();
    }
    if (stage == Stage::Vertex)
      checkAttributeTypes(stream, irisProgramOf(entry_.name), built_.diagnostics);
    const bool judged = addIrisText(stage, stream);
    if (judged && context_.judgedOnly) {
      built_.stages.push_back({stage, {}});
      return;
    }
    RewriteResult result = rewrite(stream, stage, names_);
    built_.writesFragData |= result.writesFragData;
    addRules(result.rules, built_.rules);
    if (entry_.name.group == ProgramGroup::Voxy) keepVoxyVersion(stream);
    built_.stages.push_back({stage, print(stream)});
    addToHash(stageName(stage), built_.stages.back().text.text);
  }

  /// false: it is the text for drawing that is judged.
  bool addIrisText(Stage stage, const TokenStream& stream) {
    const IrisProgram program = irisProgramOf(entry_.name);
    if (!context_.irisTexts || program.patch == IrisPatch::None) return false;
    TokenStream own = stream;
    addIrisRules(rewriteAsIris(own, stage, program, names_).rules, built_.rules);
    built_.irisStages.push_back({stage, print(own)});
    return true;
  }

  // A const line inside a comment is a directive although no token of the text names it.
  void watchConstLines() {
    const auto& names = context_.optionNames;
    for (const ConstLine& line : built_.constLines) {
      const auto at = std::lower_bound(names.begin(), names.end(), line.name);
      if (at != names.end() && *at == line.name) {
        watch_.uses[static_cast<size_t>(at - names.begin())] |= NameWatch::kText;
      }
    }
  }

  void addCompute(const std::string& name, PreprocessedPart& part) {
    TokenStream& stream = take(part);
    ComputeSource compute{.name = name};
    compute.directives = readProgramDirectives(stream, kColorTargets, built_.diagnostics);
    compute.localSize = readLocalSize(stream.tokens);
    if (context_.irisTexts) {
      TokenStream own = stream;
      addIrisRules(rewriteAsIris(own, Stage::Compute, {.patch = IrisPatch::Compute}).rules,
                   compute.rules);
      compute.irisText = {Stage::Compute, print(own)};
    }
    addRules(rewrite(stream, Stage::Compute, liveNames()).rules, compute.rules);
    compute.text = {Stage::Compute, print(stream)};
    addToHash(name, compute.text.text.text);
    built_.computes.push_back(std::move(compute));
  }

  // The other rules are those of the text for drawing, and counted there.
  static void addIrisRules(std::vector<AppliedRule> rules, std::vector<AppliedRule>& all) {
    std::erase_if(rules, [](const AppliedRule& r) { return !r.rule.starts_with("iris-"); });
    addRules(rules, all);
  }

  static void addRules(const std::vector<AppliedRule>& rules, std::vector<AppliedRule>& all) {
    for (const AppliedRule& rule : rules) {
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
    ProgramSource& source = built_;
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
  std::vector<HostName> names_;  ///< of the kind of program, then live options
  ProgramSource built_;
  NameWatch watch_;
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

}  // namespace

std::size_t partCount(const ProgramEntry& entry) {
  return entry.stages.size() + entry.computes.size();
}

Stage stageOfPart(const ProgramEntry& entry, std::size_t part) {
  return part < entry.stages.size() ? entry.stages[part].first : Stage::Compute;
}

PreprocessedPart preprocessPart(const ProgramEntry& entry, std::size_t part,
                                const BuildContext& context) {
  const bool draws = part < entry.stages.size();
  const std::string& file =
      draws ? entry.stages[part].second : entry.computes[part - entry.stages.size()].second;
  const bool voxy = entry.name.group == ProgramGroup::Voxy;
  PreprocessedPart result;
  if (file.empty()) {
    result.stream =
        voxy ? voxyVertex() : preprocess(defaultVertexSource(), context.macros, result.diagnostics);
    return result;
  }
  NameWatch watch(context.optionNames);
  const FlatSource flat = flatten(context.graph, context.files, file, result.diagnostics);
  result.stream = preprocess(flat, context.macros, result.diagnostics, &watch);
  result.optionUses = std::move(watch.uses);
  if (voxy) {
    result.stream = voxyFragment(std::move(result.stream), context.voxyPrelude);
  } else {
    requireVersion(result.stream, result.diagnostics);
  }
  return result;
}

ProgramSource finishProgram(const ProgramEntry& entry, const BuildContext& context,
                            std::vector<PreprocessedPart> parts) {
  return ProgramBuild(entry, context).run(std::move(parts));
}

}  // namespace orris
