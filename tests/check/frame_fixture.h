// Small packs in memory for the checks of the frame.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

#include <orris/check/frame/frame_view.h>
#include <orris/check/pack/pack_checks.h>
#include "text_fixture.h"

namespace orris {

/// A fragment stage: line 2 is the directive, then a line for each sampler, then `body` in main.
inline std::string fragmentStage(const std::string& targets,
                                 const std::vector<std::string>& samplers,
                                 const std::string& body = "") {
  std::string text = kVersion;
  text += targets.empty() ? "\n" : "/* RENDERTARGETS: " + targets + " */\n";
  for (const std::string& name : samplers) text += "uniform sampler2D " + name + ";\n";
  text += "void main() {\n  vec4 c = vec4(0.0);\n";
  for (const std::string& name : samplers) text += "  c += texture2D(" + name + ", vec2(0.5));\n";
  return text + body + "  gl_FragData[0] = c;\n}\n";
}

inline void addProgram(Files& files, const std::string& program, const std::string& fragment) {
  files["/" + program + ".vsh"] = kVertexStage;
  files["/" + program + ".fsh"] = fragment;
}

/// A pack whose composite draws to colortex1 and whose final program shows that.
inline Files cleanPack() {
  Files files;
  addProgram(files, "composite", fragmentStage("1", {"colortex0"}));
  addProgram(files, "final", fragmentStage("", {"colortex1"}));
  return files;
}

/// First lines ("place: severity: message") and hints of what one check says about a pack.
template <typename Check>
std::vector<std::string> messagesOf(Check check, const Files& files) {
  const ShaderPack pack = loadClean(files);
  Diagnostics diagnostics;
  const Schedule schedule = buildSchedule(pack, 64, 32, {}, diagnostics);
  if constexpr (std::is_invocable_v<Check, FrameView, Diagnostics&>) {
    check(FrameView(pack, schedule), diagnostics);
  } else {
    check({.pack = pack, .schedule = schedule, .target = targetTable().front()}, diagnostics);
  }
  std::vector<std::string> messages;
  for (const Diagnostic& d : diagnostics) {
    const std::string text = formatDiagnostic(d);
    messages.push_back(d.id + " " + text.substr(0, text.find('\n')) + " | " + d.hint);
  }
  return messages;
}

}  // namespace orris
