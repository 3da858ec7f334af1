// What programs write and read against the formats of the buffers.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include <orris/check/compile/program_text.h>
#include <orris/check/frame/frame_checks.h>
#include <orris/check/interface/stage_interface.h>
#include <orris/image/texel_format.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

const TextureFormat* formatOf(const FrameView& frame, bool shadow, int index) {
  const TargetPlan* plan = frame.schedule.target(shadow, index);
  return plan == nullptr ? nullptr : findFormat(plan->format);
}

/// f, i or u: the numbers of an output type or a format.
char formatKind(std::string_view type) {
  return type.starts_with('i') || type.starts_with('u') ? type[0] : 'f';
}
char formatKind(const TextureFormat& format) {
  if (format.formatClass == FormatClass::Int) return 'i';
  return format.formatClass == FormatClass::Uint ? 'u' : 'f';
}

std::string_view typeFor(char kind) {
  return kind == 'i' ? "ivec4" : kind == 'u' ? "uvec4" : "vec4";
}

void reportOutput(const FrameView& frame, const FramePass& pass, int slot, std::string_view type,
                  const StageText& stage, const TextPlace& place, Diagnostics& diagnostics) {
  if (slot < 0 || static_cast<size_t>(slot) >= pass.writes.size()) return;
  const bool shadow = pass.isShadowGroup();
  const int index = pass.writes[static_cast<size_t>(slot)];
  const TextureFormat* format = formatOf(frame, shadow, index);
  if (format == nullptr || formatKind(*format) == formatKind(type)) return;
  Diagnostic d = diagnosticAt(
      frame.pack, Severity::Warning, "output-format", stage.text.locate(place.line, place.column),
      fmt::format("{} writes {} to {}, whose format is {}", pass.name, type,
                  targetTitle(shadow, index), format->name),
      fmt::format("declare the output as {}, or give the buffer another format",
                  typeFor(formatKind(*format))));
  d.includedFrom = stage.text.includedFrom(place.line, place.column);
  diagnostics.push_back(std::move(d));
}

void checkOutputsOf(const FrameView& frame, const FramePass& pass, Diagnostics& diagnostics) {
  const StageText& stage = pass.program->stages.back();
  const StageInterface interface = readStageInterface(stage);
  const auto isOutput = [](const StageGlobal& global) {
    return global.storage == StageGlobal::Storage::Out && global.used && !global.block;
  };
  const auto outputs = std::count_if(interface.globals.begin(), interface.globals.end(), isOutput);
  for (const StageGlobal& global : interface.globals) {
    if (!isOutput(global) || global.type.starts_with('d')) continue;
    // Without a location the linker numbers them; a single one gets 0.
    const int slot = global.layout.location < 0 && outputs == 1 ? 0 : global.layout.location;
    reportOutput(frame, pass, slot, global.type, stage, global.place, diagnostics);
  }
  for (const FragDataUse& use : interface.fragData)
    reportOutput(frame, pass, use.index, "vec4", stage, use.place, diagnostics);
}

/// Letters after the call that samples the buffer at `place`: "rgb" of "texture(colortex3, uv).rgb".
std::string_view swizzleAt(const WordPlace& place) {
  const std::string_view text = place.stage->text.text;
  const std::string_view before = trim(text.substr(0, place.offset));
  if (!before.ends_with('(')) return {};
  const std::string_view head = trim(before.substr(0, before.size() - 1));
  size_t begin = head.size();
  while (begin > 0 && isWordCharacter(head[begin - 1])) --begin;
  const std::string_view function = head.substr(begin);
  if (!function.starts_with("texture") && function != "texelFetch") return {};
  if (function.find("Gather") != std::string_view::npos || function == "textureSize") return {};
  const auto call = callAt(text, head.size());
  if (!call || call->end >= text.size() || text[call->end] != '.') return {};
  const std::string_view swizzle = leadingWord(text.substr(call->end + 1));
  const auto isComponent = [](char c) {
    return std::string_view("xyzwrgbastpq").find(c) != std::string_view::npos;
  };
  return std::all_of(swizzle.begin(), swizzle.end(), isComponent) ? swizzle : std::string_view();
}

int componentIndex(char c) {
  for (const std::string_view names : {"xyzw", "rgba", "stpq"})
    if (const size_t at = names.find(c); at != std::string_view::npos) return static_cast<int>(at);
  return 0;
}

void checkComponentsOf(const FrameView& frame, const FramePass& pass, const BufferUse& use,
                       Diagnostics& diagnostics) {
  const bool shadow = use.inShadowMap();
  const TextureFormat* format = formatOf(frame, shadow, use.buffer.index);
  if (format == nullptr || format->channels == 4) return;
  const bool computes = pass.kind == FramePass::Kind::Compute;
  for (const WordPlace& place : findUses(*pass.program, computes, use.name)) {
    const std::string_view swizzle = swizzleAt(place);
    const bool allMissing =
        !swizzle.empty() && std::all_of(swizzle.begin(), swizzle.end(), [&](char c) {
          return componentIndex(c) >= format->channels;
        });
    if (!allMissing) continue;
    const auto& m = frame.mentions();
    const auto& formats = shadow ? m.shadowFormats : m.formats;
    const auto known = formats.find(use.buffer.index);
    const bool several = known != formats.end() && known->second.size() > 1;
    diagnostics.push_back(diagnosticAt(
        frame.pack, several ? Severity::Note : Severity::Warning, "format-narrow", place,
        fmt::format("{} reads .{} of {}, but its format {} has {} component{}: it is always {}",
                    pass.name, swizzle, targetTitle(shadow, use.buffer.index), format->name,
                    format->channels, format->channels == 1 ? "" : "s",
                    componentIndex(swizzle[0]) == 3 ? 1 : 0),
        "give the buffer a format with that component"));
  }
}

}  // namespace

void checkOutputFormats(const FrameView& frame, Diagnostics& diagnostics) {
  for (const FramePass& pass : frame.passes) {
    const bool draws = pass.isGeometry() || pass.kind == FramePass::Kind::Fullscreen;
    if (draws && pass.program != nullptr && !pass.program->stages.empty())
      checkOutputsOf(frame, pass, diagnostics);
  }
}

void checkComponents(const FrameView& frame, Diagnostics& diagnostics) {
  for (const FramePass& pass : frame.passes)
    for (const BufferUse& use : pass.uses)
      if (use.isTarget() && !use.buffer.image && pass.program != nullptr)
        checkComponentsOf(frame, pass, use, diagnostics);
}

}  // namespace orris
