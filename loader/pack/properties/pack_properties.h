// shaders.properties and the id maps under certain option values.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/files/pack_files.h>
#include <orris/pack/ids/id_map.h>

namespace orris {

struct PackProperties {
  ShaderProperties shader;
  BlockIdMap blockIds;
  std::map<std::string, int> itemIds, entityIds;
  MacroDefinitions macros;           ///< what the *.properties files are preprocessed with
  bool hasItemFile = false;          ///< item.properties exists
  MacroDefinitions shaderMacros;     ///< what every shader sees: environment and feature flags
  std::vector<std::string> options;  ///< those that the files ask for; no other changes anything
  std::vector<std::string> modMacros;  ///< macros of other mods that the files ask for
  Diagnostics diagnostics;
  bool refused = false;  ///< shaders.properties has errors, for which Iris refuses the pack
};

PackProperties readPackProperties(const PackFiles& files, const OptionValues& values,
                                  const MacroDefinitions& environment);

/// As they are with one more macro, which the files do not ask for.
PackProperties withMacro(PackProperties properties, std::string_view macro, std::string_view value);

}  // namespace orris
