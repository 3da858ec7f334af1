// Small packs and what the checks of declarations tell of them.
#pragma once

#include <orris/check/interface/declaration_checks.h>
#include "frame_fixture.h"

namespace orris {

/// A pack of one composite; the texts follow the line of the version.
inline Files packOf(const std::string& vertex, const std::string& fragment,
                    const std::string& properties = "") {
  Files files{{"/composite.vsh", kVersion + vertex}, {"/composite.fsh", kVersion + fragment}};
  if (!properties.empty()) files["/shaders.properties"] = properties;
  return files;
}

inline Files fragmentOf(const std::string& fragment, const std::string& properties = "") {
  return packOf("void main() { gl_Position = ftransform(); }\n", fragment, properties);
}

/// Everything but notes, by place.
inline Lines messages(const Files& files, const std::string& target = "iris", bool notes = false) {
  const ShaderPack pack = loadClean(files);
  Diagnostics diagnostics;
  const Schedule schedule = buildSchedule(pack, 64, 32, {}, diagnostics);
  checkDeclarations({.pack = pack, .schedule = schedule, .target = *findTarget(target)},
                    diagnostics);
  Lines lines;
  for (const Diagnostic& d : diagnostics) {
    if (d.severity == Severity::Note && !notes) continue;
    const std::string text = formatDiagnostic(d);
    std::string line = d.id + " " + text.substr(0, text.find('\n'));
    for (const RelatedPlace& place : d.related)
      line += "; " + formatLocation(place.at) + ": " + place.message;
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace orris
