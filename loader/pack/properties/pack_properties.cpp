#include <orris/pack/properties/pack_properties.h>

#include <algorithm>
#include <set>

#include <orris/core/files/text_file.h>
#include <orris/glsl/preprocess/name_watch.h>
#include <orris/pack/files/text.h>
#include <orris/pack/ids/legacy_ids.h>
#include <orris/pack/mods/mods.h>
#include <orris/pack/options/auto_properties.h>
#include <orris/pack/properties/counter_warning.h>
#include <orris/pack/properties/latin_text.h>
#include <orris/pack/properties/resource_check.h>
#include <orris/pack/versions/features.h>

namespace orris {
namespace {

/// Environment, features and options as *.properties files see them: no macro is empty there.
MacroDefinitions propertyMacros(const PackFiles& files, const OptionValues& values,
                                const MacroDefinitions& environment) {
  MacroDefinitions macros;
  for (const auto& [name, option] : files.options.all()) {
    const std::string value = files.options.value(values, name);
    if (!option.isBoolean || value == "true")
      macros.emplace_back(name, option.isBoolean ? "1" : value);
  }
  // Feature flags are Iris's.
  const auto iris = irisVersionOf(environment);
  const MacroDefinitions features = iris ? propertyFeatureMacros(*iris) : MacroDefinitions();
  for (const MacroDefinitions* more : {&environment, &features}) {
    for (const auto& [name, body] : *more) macros.emplace_back(name, body.empty() ? "1" : body);
  }
  return macros;
}

bool isModMacro(std::string_view name) {
  return std::ranges::find(modFamilies(), name, &ModFamily::macro) != modFamilies().end();
}

/// Sorted, each once.
std::vector<std::string> watchedNames(const PackFiles& files) {
  std::set<std::string> names(files.optionNames.begin(), files.optionNames.end());
  for (const ModFamily& mod : modFamilies()) names.emplace(mod.macro);
  return {names.begin(), names.end()};
}

void readIds(const PackFiles& files, const MacroDefinitions& macros, NameWatch& watch,
             PackProperties& out) {
  const auto read = [&](const std::string& file, auto parse) {
    const auto text = readText(*files.source, file, out.diagnostics);
    if (!text) return;
    const std::string active = preprocessProperties(file, *text, macros, out.diagnostics, &watch);
    parse(file, upToForeignCharacter(file, *text, active, out.diagnostics), *text);
  };
  const auto version =
      std::ranges::find(macros, "MC_VERSION", &MacroDefinitions::value_type::first);
  out.blockIds = legacyBlockIds(
      version == macros.end() ? kShortGrassVersion : parseInteger(version->second).value_or(0));
  read("/block.properties", [&](auto& file, const auto& text, auto& original) {
    out.blockIds = parseBlockProperties(file, text, original, out.diagnostics);
  });
  read("/item.properties", [&](auto& file, const auto& text, auto& original) {
    out.hasItemFile = true;
    out.itemIds = parseIdProperties(file, text, original, "item.", out.diagnostics);
  });
  read("/entity.properties", [&](auto& file, const auto& text, auto& original) {
    out.entityIds = parseIdProperties(file, text, original, "entity.", out.diagnostics);
  });
}

}  // namespace

PackProperties readPackProperties(const PackFiles& files, const OptionValues& values,
                                  const MacroDefinitions& environment) {
  PackProperties out;
  const std::vector<std::string> watched = watchedNames(files);
  NameWatch watch(watched);
  const MacroDefinitions macros = propertyMacros(files, values, environment);
  if (files.properties) {
    out.shader = parseShaderProperties(kPropertiesFile, *files.properties, macros, files.options,
                                       out.diagnostics, &watch);
    // Read again by whoever chooses or warns; here for what is wrong with them.
    if (asksForAuto(out.shader))
      parseAutoOptions(kPropertiesFile, *files.properties, macros, files.options, out.diagnostics);
    parseCounterWarnings(kPropertiesFile, *files.properties, macros, out.shader, out.diagnostics);
    checkDeclared(out.shader, out.diagnostics);
    checkResources(out.shader, *files.source, out.diagnostics);
  }
  out.refused = hasErrors(out.diagnostics);
  out.shaderMacros = environment;
  if (const auto iris = irisVersionOf(environment)) {
    for (auto& macro : shaderFeatureMacros(out.shader, *iris))
      out.shaderMacros.push_back(std::move(macro));
  }
  readIds(files, macros, watch, out);
  for (std::string& name : watch.used()) {
    if (isModMacro(name)) out.modMacros.push_back(name);
    if (files.options.find(name)) out.options.push_back(std::move(name));
  }
  out.macros = macros;
  return out;
}

PackProperties withMacro(PackProperties properties, std::string_view macro, std::string_view value) {
  properties.macros.emplace_back(macro, "1");
  properties.shaderMacros.emplace_back(macro, value);
  return properties;
}

}  // namespace orris
