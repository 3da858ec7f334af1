#include <orris/check/logs/game_log.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include <orris/core/characters.h>
#include <orris/glsl/compile/compiler_log.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::array<std::string_view, 3> kHeadings = {
    "Shader compilation log for ", "Program link log for ", "ShaderCompileException: "};

bool isNameCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) ||
         std::string_view("_-.:/").find(c) != std::string_view::npos;
}

/// "NAME: " at the start of `text`; takes it off.
std::string takeName(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && isNameCharacter(text[end])) ++end;
  // The name may hold colons itself ("iris:sodium-shader-terrain_solid"), but ends before one.
  if (end == 0 || text[end - 1] != ':') return "";
  if (end < text.size() && text[end] != ' ') return "";
  const std::string name(text.substr(0, end - 1));
  text = trim(text.substr(end));
  return name;
}

struct Opening {
  std::string name;
  std::string_view rest;
};

/// "NAME: NAME: rest" after an exception's class, and as players paste it.
std::optional<Opening> takeRepeatedName(std::string_view text) {
  const std::string name = takeName(text);
  std::string_view rest = text;
  if (name.empty() || takeName(rest) != name) return std::nullopt;
  return Opening{name, rest};
}

std::optional<Opening> readOpening(std::string_view line) {
  for (const std::string_view heading : kHeadings) {
    const std::size_t at = line.find(heading);
    if (at == std::string_view::npos) continue;
    std::string_view rest = line.substr(at + heading.size());
    if (const auto repeated = takeRepeatedName(rest)) return repeated;
    const std::string name = takeName(rest);
    if (!name.empty()) return Opening{name, rest};
  }
  return takeRepeatedName(trim(line));
}

// What the game writes itself ends a driver's text: the next entry, or the stack of an exception.
bool endsSection(std::string_view line) {
  const std::string_view text = trim(line);
  const bool entry = line.starts_with('[') && line.size() > 2 &&
                     (isDigit(line[1]) || line.find("] [") != std::string_view::npos);
  return text.empty() || entry || text.starts_with("at ") || text.starts_with("Caused by:") ||
         text.starts_with("... ");
}

bool isDriverMessage(std::string_view line) {
  const auto entries = parseCompilerLog(line, Severity::Note);
  return !entries.empty() && entries.front().line > 0;
}

struct Drawn {
  std::string_view key, program;
};

// Sorted by key. Where the key is the program's own name without "gbuffers_", it is left out.
constexpr Drawn kDrawn[] = {
    {"basic_color", "gbuffers_basic"},
    {"be_translucent", "gbuffers_block_translucent"},
    {"beacon", "gbuffers_beaconbeam"},
    {"block_entity", "gbuffers_block"},
    {"block_entity_bright", "gbuffers_block"},
    {"block_entity_diffuse", "gbuffers_block"},
    {"clouds_sodium", "gbuffers_clouds"},
    {"crumbling", "gbuffers_damagedblock"},
    {"entities_alpha", "gbuffers_entities"},
    {"entities_cutout", "gbuffers_entities"},
    {"entities_cutout_diffuse", "gbuffers_entities"},
    {"entities_eyes", "gbuffers_spidereyes"},
    {"entities_eyes_trans", "gbuffers_spidereyes"},
    {"entities_solid", "gbuffers_entities"},
    {"entities_solid_bright", "gbuffers_entities"},
    {"entities_solid_diffuse", "gbuffers_entities"},
    {"glint", "gbuffers_armor_glint"},
    {"hand_cutout", "gbuffers_hand"},
    {"hand_cutout_bright", "gbuffers_hand"},
    {"hand_cutout_diffuse", "gbuffers_hand"},
    {"hand_text", "gbuffers_hand"},
    {"hand_text_intensity", "gbuffers_hand"},
    {"hand_translucent", "gbuffers_hand_water"},
    {"hand_water_bright", "gbuffers_hand_water"},
    {"hand_water_diffuse", "gbuffers_hand_water"},
    {"ie_compat", "gbuffers_block"},
    {"ie_compat_shadow", "shadow_entities"},
    {"leash", "gbuffers_basic"},
    {"lines", "gbuffers_line"},
    {"mekanism_flame", "gbuffers_spidereyes"},
    {"mekanism_flame_shadow", "shadow_entities"},
    {"moving_block", "gbuffers_block"},
    {"particles_trans", "gbuffers_particles_translucent"},
    {"shadow_basic", "shadow"},
    {"shadow_basic_color", "shadow"},
    {"shadow_beacon_beam", "shadow_entities"},
    {"shadow_clouds", "shadow"},
    {"shadow_entities_cutout", "shadow_entities"},
    {"shadow_leash", "shadow"},
    {"shadow_lines", "shadow"},
    {"shadow_particles", "shadow"},
    {"shadow_tex", "shadow"},
    {"shadow_tex_color", "shadow"},
    {"shadow_terrain_cutout", "shadow_cutout"},
    {"shadow_text", "shadow_entities"},
    {"shadow_text_bg", "shadow_entities"},
    {"shadow_text_intensity", "shadow_entities"},
    {"shadow_translucent", "shadow_water"},
    {"sky_basic", "gbuffers_skybasic"},
    {"sky_basic_color", "gbuffers_skybasic"},
    {"sky_textured", "gbuffers_skytextured"},
    {"sky_textured_color", "gbuffers_skytextured"},
    {"sps", "gbuffers_terrain"},
    {"terrain_cutout", "gbuffers_terrain_cutout"},
    {"terrain_solid", "gbuffers_terrain_solid"},
    {"terrain_translucent", "gbuffers_water"},
    {"text", "gbuffers_entities_translucent"},
    {"text_be", "gbuffers_block_translucent"},
    {"text_bg", "gbuffers_entities_translucent"},
    {"text_intensity", "gbuffers_entities_translucent"},
    {"text_intensity_be", "gbuffers_block_translucent"},
    {"textured_color", "gbuffers_textured"},
    {"translucent", "gbuffers_water"},
};

}  // namespace

std::vector<LogSection> parseGameLog(std::string_view text) {
  std::vector<LogSection> sections;
  bool open = false;
  const std::vector<std::string> lines = splitLines(text);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int number = static_cast<int>(i) + 1;
    if (const auto opening = readOpening(lines[i])) {
      sections.push_back({opening->name, number, std::string(opening->rest)});
      open = true;
    } else if (endsSection(lines[i])) {
      open = false;
    } else if (open) {
      sections.back().text += "\n" + lines[i];
    } else if (isDriverMessage(lines[i])) {
      sections.push_back({"", number, lines[i]});
      open = true;
    }
  }
  std::set<std::pair<std::string, std::string>> seen;
  std::erase_if(sections, [&seen](const LogSection& section) {
    return !seen.emplace(section.name, trim(section.text)).second;
  });
  return sections;
}

LoggedShader shaderOfLogName(std::string_view name) {
  LoggedShader shader;
  const std::size_t dot = name.rfind('.');
  if (dot != std::string_view::npos) {
    shader.stage = name.substr(dot + 1);
    name = name.substr(0, dot);
  }
  for (const std::string_view prefix : {"iris:", "sodium-shader-", "sodium_"}) {
    if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  }
  const auto drawn = std::ranges::find(kDrawn, name, &Drawn::key);
  shader.program = drawn == std::end(kDrawn) ? name : drawn->program;
  return shader;
}

}  // namespace orris
