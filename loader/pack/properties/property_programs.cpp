// Keys that name a program: enabled, alphaTest, blend, flip, scale, size.buffer, indirect.
#include <fmt/format.h>

#include <algorithm>

#include <orris/pack/expressions/boolean_expression.h>
#include <orris/pack/files/text.h>
#include <orris/pack/programs/program_id.h>
#include <orris/pack/properties/property_keys.h>
#include <orris/pack/properties/texture_format.h>

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
const std::vector<std::string> kBufferNames{"colortex0 to colortex31",
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
               fmt::format("did you mean {}{}?", nearest, program.substr(stem.size())), program);
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

/// How Iris separates the words of a value: at single blanks.
std::vector<std::string> singleBlankWords(const PropertyContext& context) {
  return splitSingleBlanks(context.entry.value);
}

constexpr const char* kOneBlank = "write one blank between two words, and no tab";

bool hasWideGap(std::string_view value) {
  return value.find("  ") != std::string_view::npos || value.find('\t') != std::string_view::npos;
}

/// The first four factors, of which each must be one; nullopt and an error otherwise.
std::optional<BlendMode> parseBlend(const PropertyContext& context) {
  BlendMode mode;
  if (context.entry.value == "off") {
    mode.off = true;
    return mode;
  }
  const auto words = singleBlankWords(context);
  const bool gap = hasWideGap(context.entry.value);
  for (const std::string& word : words) {
    if (std::find(kBlendFactors.begin(), kBlendFactors.end(), word) != kBlendFactors.end())
      continue;
    const std::string hint = suggest(word, kBlendFactors);
    context.refuse("blend-factor",
                   gap ? fmt::format("{} has two blanks side by side or a tab", context.entry.key)
                       : fmt::format("{} is no blend factor", word),
                   gap            ? kOneBlank
                   : hint.empty() ? fmt::format("factors are {}", fmt::join(kBlendFactors, ", "))
                                  : hint,
                   gap ? std::string() : word);
    return std::nullopt;
  }
  if (words.size() < mode.factors.size()) {
    context.refuse("blend-syntax",
                   fmt::format("{} has {} words, expected off or four factors", context.entry.key,
                               words.size()),
                   "source, destination, source alpha, destination alpha");
    return std::nullopt;
  }
  std::copy_n(words.begin(), mode.factors.size(), mode.factors.begin());
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

/// "A & B"
bool hasSingleOperator(std::string_view condition) {
  for (size_t i = 0; i < condition.size(); ++i) {
    if (condition[i] != '&' && condition[i] != '|') continue;
    if (i + 1 == condition.size() || condition[i + 1] != condition[i]) return true;
    ++i;
  }
  return false;
}

/// Does Iris read each side, a whole number or one with a dot?
bool areSides(const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(), [](const std::string& word) {
    const bool relative = word.find('.') != std::string::npos;
    return relative ? parseFloat(word).has_value() : parseInteger(word).has_value();
  });
}

/// A colortex with whatever number: Iris refuses others as buffer of a blend mode.
bool hasBufferNumber(std::string_view name) {
  constexpr std::string_view kPrefix = "colortex";
  return name.starts_with(kPrefix) && parseInteger(name.substr(kPrefix.size()));
}

/// Of "world1/program.begin.enabled" the key that the author means.
std::string meantProgram(std::string_view rest) {
  constexpr std::string_view kAgain = "/program.", kEnd = ".enabled";
  const size_t again = rest.find(kAgain);
  if (again == std::string_view::npos || !rest.ends_with(kEnd)) {
    const bool slip = !suggest(rest.substr(rest.rfind('.') + 1), {"enabled"}).empty();
    return slip ? "write .enabled" : "program.<name>.enabled is all that Iris knows of programs";
  }
  return fmt::format("write program.{}/{}", rest.substr(0, again),
                     rest.substr(again + kAgain.size()));
}

}  // namespace

void readProgramEnabled(const PropertyContext& context, std::string_view rest) {
  const size_t dot = rest.find('.');
  if (dot == std::string_view::npos) {
    context.refuse("property-value", fmt::format("{} names no property", context.entry.key),
                   "write program.<name>.enabled=<condition>");
    return;
  }
  const std::string program(rest.substr(0, dot));
  checkProgram(context, program.substr(program.rfind('/') + 1));
  if (rest.substr(dot) != ".enabled") {
    context.warn("property-value",
                 fmt::format("Iris takes {} for program.{}.enabled", context.entry.key, program),
                 meantProgram(rest));
  }
  if (hasSingleOperator(context.entry.value)) {
    context.warn("program-condition",
                 "Iris takes one & or | for two and passes over the character after it",
                 "write && and ||");
  }
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
  AlphaTest test;
  if (context.entry.value == "off" || context.entry.value == "false") {
    test.off = true;
  } else {
    const auto words = singleBlankWords(context);
    const std::string function = words[0] == "GL_ALWAYS" ? "ALWAYS" : words[0];
    const bool known = std::find(kAlphaFunctions.begin(), kAlphaFunctions.end(), function) !=
                       kAlphaFunctions.end();
    const auto reference = words.size() > 1 ? parseFloat(words[1]) : std::nullopt;
    if (!known || !reference) {
      context.ignore("alpha-test",
                     fmt::format("{} is \"{}\", expected off or FUNCTION REFERENCE",
                                 context.entry.key, context.entry.value),
                     hasWideGap(context.entry.value)
                         ? kOneBlank
                         : fmt::format("functions are {}", fmt::join(kAlphaFunctions, ", ")));
      return;
    }
    test.function = function;
    test.reference = *reference;
  }
  context.out.alphaTest[std::string(program)] = test;
}

void readBlend(const PropertyContext& context, std::string_view rest) {
  const size_t dot = rest.find('.');
  const std::string program(rest.substr(0, dot));
  checkProgram(context, program);
  std::string buffer;
  if (dot != std::string_view::npos) {
    std::string_view name = rest.substr(dot + 1);
    name = name.substr(0, name.find('.'));
    buffer = knownBuffer(name);
    if (buffer.empty() && !hasBufferNumber(name)) {
      context.refuse("buffer-unknown", fmt::format("no buffer is called {}", name),
                     fmt::format("buffers are {}", fmt::join(kBufferNames, ", ")), name);
      return;
    }
    if (buffer.empty()) requireBuffer(context, name);
  }
  const auto mode = parseBlend(context);
  if (!mode) return;
  if (dot == std::string_view::npos) {
    context.out.blend[program] = *mode;
  } else if (!buffer.empty()) {
    context.out.bufferBlend[program][buffer] = *mode;
  }
}

void readFlip(const PropertyContext& context, std::string_view rest) {
  const size_t dot = rest.find('.');
  if (dot == std::string_view::npos) {
    context.refuse("property-value", fmt::format("{} names no buffer", context.entry.key),
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
    context.ignore("property-value", fmt::format("{} is \"{}\", expected true or false",
                                                 context.entry.key, context.entry.value));
  } else if (!buffer.empty()) {
    context.out.flip[std::string(program)][buffer] = *flip;
  }
}

void readScale(const PropertyContext& context, std::string_view program) {
  checkProgram(context, program);
  auto words = singleBlankWords(context);
  words.resize(std::min<size_t>(words.size(), 3));
  const auto values = parseFloats(words);
  if (!values || (values->size() != 1 && values->size() != 3)) {
    context.ignore("property-value",
                   fmt::format("{} is \"{}\", expected SCALE or SCALE X Y", context.entry.key,
                               context.entry.value),
                   hasWideGap(context.entry.value) ? kOneBlank : "");
    return;
  }
  std::array<float, 3> scale{1, 0, 0};
  std::copy(values->begin(), values->end(), scale.begin());
  context.out.scale[std::string(program)] = scale;
}

void readBufferSize(const PropertyContext& context, std::string_view name) {
  const std::string buffer = requireBuffer(context, name);
  const auto words = singleBlankWords(context);
  const std::string message =
      fmt::format("{} is \"{}\", expected WIDTH HEIGHT", context.entry.key, context.entry.value);
  constexpr const char* kSides =
      "a number with a dot is relative to the window, one without is in pixels";
  if (words.size() != 2) {
    return context.ignore("property-value", message,
                          hasWideGap(context.entry.value) ? kOneBlank : kSides);
  }
  if (!areSides(words)) return context.refuse("property-value", message, kSides);
  if (buffer.empty()) return;
  const auto values = parseFloats(words);
  constexpr float kLargest = 16384;
  if (!values || (*values)[0] <= 0 || (*values)[1] <= 0 || (*values)[0] > kLargest ||
      (*values)[1] > kLargest) {
    return context.warn("property-value", message, kSides);
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
  const auto words = singleBlankWords(context);
  const auto index = words.size() >= 2 ? parseInteger(words[0]) : std::nullopt;
  const auto offset = words.size() >= 2 ? parseInteger(words[1]) : std::nullopt;
  if (!index || !offset || *index < 0 || *index > 8 || *offset < 0) {
    context.ignore(
        "property-value",
        fmt::format("{} is \"{}\", expected BUFFER OFFSET", context.entry.key, context.entry.value),
        "the buffer is the index of a bufferObject, 0 to 8; the offset is in bytes");
    return;
  }
  context.out.indirect[std::string(program)] = {static_cast<int>(*index), *offset};
}

}  // namespace orris
