// Keys that name a program: enabled, alphaTest, blend, flip, scale, size.buffer, indirect.
#include <fmt/format.h>

#include <algorithm>

#include "pack/boolean_expression.h"
#include "pack/program_id.h"
#include "pack/property_keys.h"
#include "pack/text.h"
#include "pack/texture_format.h"

namespace orris {
namespace {

const std::vector<std::string> kAlphaFunctions{"NEVER",   "LESS",     "EQUAL",  "LEQUAL",
                                               "GREATER", "NOTEQUAL", "GEQUAL", "ALWAYS"};
const std::vector<std::string> kBlendFactors{"ZERO",
                                             "ONE",
                                             "SRC_COLOR",
                                             "ONE_MINUS_SRC_COLOR",
                                             "DST_COLOR",
                                             "ONE_MINUS_DST_COLOR",
                                             "SRC_ALPHA",
                                             "ONE_MINUS_SRC_ALPHA",
                                             "DST_ALPHA",
                                             "ONE_MINUS_DST_ALPHA",
                                             "SRC_ALPHA_SATURATE"};
const std::vector<std::string> kBufferNames{"colortex0 to colortex15",
                                            "gcolor",
                                            "gdepth",
                                            "gnormal",
                                            "composite",
                                            "gaux1",
                                            "gaux2",
                                            "gaux3",
                                            "gaux4"};

bool isProgramName(std::string_view name) {
  const std::string path = "/" + std::string(name);
  return parseProgramFile(path + ".fsh") || parseProgramFile(path + ".csh");
}

/// Newer hosts know more programs than this one, so only a near miss is reported.
void checkProgram(const PropertyContext& context, std::string_view program) {
  if (isProgramName(program)) return;
  std::vector<std::string> names{"final", "composite",  "deferred", "prepare",
                                 "begin", "shadowcomp", "setup"};
  for (const GeometryProgram& known : geometryPrograms()) names.emplace_back(known.name);
  const std::string_view stem = program.substr(0, program.find_first_of("0123456789"));
  const std::string nearest = nearestName(stem, names);
  if (nearest.empty() || stem.starts_with("dh_") || nearest.starts_with(stem)) return;
  // "gbuffers_terrain_translucent" is no slip of "gbuffers_terrain_cutout".
  const size_t difference =
      std::max(nearest.size(), stem.size()) - std::min(nearest.size(), stem.size());
  if (difference > 2) return;
  context.warn("program-unknown", fmt::format("no program is called {}", program),
               fmt::format("did you mean {}?", nearest), program);
}

/// "" and a warning when the host has no such buffer.
std::string requireBuffer(const PropertyContext& context, std::string_view name) {
  std::string buffer = knownBuffer(name);
  if (buffer.empty()) {
    context.warn("buffer-unknown", fmt::format("no buffer is called {}", name),
                 fmt::format("buffers are {}", fmt::join(kBufferNames, ", ")), name);
  }
  return buffer;
}

std::optional<BlendMode> parseBlend(const PropertyContext& context) {
  BlendMode mode;
  const auto words = splitBlanks(context.entry.value);
  if (words.size() == 1 && words[0] == "off") {
    mode.off = true;
    return mode;
  }
  if (words.size() != mode.factors.size()) {
    context.fail("blend-syntax",
                 fmt::format("{} has {} words, expected off or four factors", context.entry.key,
                             words.size()),
                 "source, destination, source alpha, destination alpha");
    return std::nullopt;
  }
  for (size_t i = 0; i < words.size(); ++i) {
    if (std::find(kBlendFactors.begin(), kBlendFactors.end(), words[i]) == kBlendFactors.end()) {
      const std::string hint = suggest(words[i], kBlendFactors);
      context.fail(
          "blend-factor", fmt::format("{} is no blend factor", words[i]),
          hint.empty() ? fmt::format("factors are {}", fmt::join(kBlendFactors, ", ")) : hint,
          words[i]);
      return std::nullopt;
    }
    mode.factors[i] = words[i];
  }
  return mode;
}

std::optional<std::vector<float>> parseFloats(const std::vector<std::string>& words) {
  std::vector<float> values;
  for (const std::string& word : words) {
    const auto value = parseFloat(word);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

}  // namespace

void readProgramEnabled(const PropertyContext& context, std::string_view rest) {
  constexpr std::string_view kSuffix = ".enabled";
  if (!rest.ends_with(kSuffix)) return;
  const std::string program(rest.substr(0, rest.size() - kSuffix.size()));
  checkProgram(context, program.substr(program.rfind('/') + 1));
  // Boolean options that are on were replaced by 1, so a name that is still here is off or unknown.
  const auto enabled = evaluateCondition(context.entry.value, [&](std::string_view name) {
    const Option* option = context.options.find(name);
    return !option || !option->isBoolean;
  });
  if (!enabled) {
    context.warn(
        "program-condition",
        fmt::format("\"{}\" is no condition; the program stays enabled", context.entry.value),
        "write names of boolean options with !, &&, || and parentheses");
  }
  context.out.programEnabled[program] = enabled.value_or(true);
}

void readAlphaTest(const PropertyContext& context, std::string_view program) {
  checkProgram(context, program);
  const auto words = splitBlanks(context.entry.value);
  AlphaTest test;
  if (words.size() == 1 && (words[0] == "off" || words[0] == "false")) {
    test.off = true;
  } else {
    std::string_view function = words.empty() ? std::string_view() : words[0];
    if (function.starts_with("GL_")) function.remove_prefix(3);
    test.function = knownName(function, kAlphaFunctions);
    const auto reference = words.size() == 2 ? parseFloat(words[1]) : std::nullopt;
    if (test.function.empty() || !reference) {
      context.warn("alpha-test",
                   fmt::format("{} is \"{}\", expected off or FUNCTION REFERENCE",
                               context.entry.key, context.entry.value),
                   fmt::format("functions are {}", fmt::join(kAlphaFunctions, ", ")));
      return;
    }
    test.reference = *reference;
  }
  context.out.alphaTest[std::string(program)] = test;
}

void readBlend(const PropertyContext& context, std::string_view rest) {
  const size_t dot = rest.find('.');
  const std::string program(rest.substr(0, dot));
  checkProgram(context, program);
  const auto mode = parseBlend(context);
  if (!mode) return;
  if (dot == std::string_view::npos) {
    context.out.blend[program] = *mode;
    return;
  }
  const std::string buffer = requireBuffer(context, rest.substr(dot + 1));
  if (!buffer.empty()) context.out.bufferBlend[program][buffer] = *mode;
}

void readFlip(const PropertyContext& context, std::string_view rest) {
  const size_t dot = rest.find('.');
  if (dot == std::string_view::npos) {
    context.warn("property-value", fmt::format("{} names no buffer", context.entry.key),
                 "write flip.<program>.<buffer>=true or false");
    return;
  }
  const std::string_view program = rest.substr(0, dot);
  checkProgram(context,
               program.ends_with("_pre") ? program.substr(0, program.size() - 4) : program);
  const std::string_view name = rest.substr(dot + 1);
  const std::string buffer =
      name.starts_with("shadowcolor") ? std::string(name) : requireBuffer(context, name);
  const auto flip = parseBoolean(context.entry.value);
  if (!flip) {
    context.warn("property-value", fmt::format("{} is \"{}\", expected true or false",
                                               context.entry.key, context.entry.value));
  } else if (!buffer.empty()) {
    context.out.flip[std::string(program)][buffer] = *flip;
  }
}

void readScale(const PropertyContext& context, std::string_view program) {
  checkProgram(context, program);
  const auto values = parseFloats(splitBlanks(context.entry.value));
  if (!values || (values->size() != 1 && values->size() != 3)) {
    context.warn("property-value", fmt::format("{} is \"{}\", expected SCALE or SCALE X Y",
                                               context.entry.key, context.entry.value));
    return;
  }
  std::array<float, 3> scale{1, 0, 0};
  std::copy(values->begin(), values->end(), scale.begin());
  context.out.scale[std::string(program)] = scale;
}

void readBufferSize(const PropertyContext& context, std::string_view name) {
  const std::string buffer = requireBuffer(context, name);
  if (buffer.empty()) return;
  const auto words = splitBlanks(context.entry.value);
  const auto values = parseFloats(words);
  constexpr float kLargest = 16384;
  if (!values || values->size() != 2 || (*values)[0] <= 0 || (*values)[1] <= 0 ||
      (*values)[0] > kLargest || (*values)[1] > kLargest) {
    context.warn(
        "property-value",
        fmt::format("{} is \"{}\", expected WIDTH HEIGHT", context.entry.key, context.entry.value),
        "a number with a dot is relative to the window, one without is in pixels");
    return;
  }
  BufferSize size;
  for (size_t axis = 0; axis < 2; ++axis) {
    size.size[axis] = (*values)[axis];
    size.relative[axis] = words[axis].find('.') != std::string::npos;
  }
  // The legacy name wins over colortexN, whichever line is later.
  if (buffer != name || !context.out.bufferSize.contains(buffer))
    context.out.bufferSize[buffer] = size;
}

void readIndirect(const PropertyContext& context, std::string_view program) {
  checkProgram(context, program);
  const auto words = splitBlanks(context.entry.value);
  const auto index = words.size() == 2 ? parseInteger(words[0]) : std::nullopt;
  const auto offset = words.size() == 2 ? parseInteger(words[1]) : std::nullopt;
  if (!index || !offset || *index < 0 || *index > 8 || *offset < 0) {
    context.warn(
        "property-value",
        fmt::format("{} is \"{}\", expected BUFFER OFFSET", context.entry.key, context.entry.value),
        "the buffer is the index of a bufferObject, 0 to 8; the offset is in bytes");
    return;
  }
  context.out.indirect[std::string(program)] = {static_cast<int>(*index), *offset};
}

}  // namespace orris
