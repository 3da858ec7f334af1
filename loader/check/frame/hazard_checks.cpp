#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include <orris/check/compile/program_text.h>
#include <orris/check/frame/frame_checks.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using Kind = FramePass::Kind;

bool draws(const FramePass& pass, const BufferUse& use) {
  return use.isColor(pass.isShadowGroup()) &&
         std::find(pass.writes.begin(), pass.writes.end(), use.buffer.index) != pass.writes.end();
}

std::string titleOf(const BufferUse& use) {
  return targetTitle(use.inShadowMap(), use.buffer.index);
}

/// The first place where the pass names something outside of declarations.
std::optional<WordPlace> firstPlace(const FramePass& pass, std::string_view name) {
  const auto places = findUses(*pass.program, pass.kind == Kind::Compute, name);
  return places.empty() ? std::nullopt : std::optional(places.front());
}

/// The second argument of the call whose first one stands at `place`, nullopt when it is none.
std::optional<std::string> coordinatesAt(std::string_view text, const WordPlace& place) {
  const std::string_view before = trim(text.substr(0, place.offset));
  if (!before.ends_with('(')) return std::nullopt;
  const std::string_view head = trim(before.substr(0, before.size() - 1));
  const auto call = callAt(text, head.size());
  if (!call || call->arguments.size() < 2) return std::nullopt;
  return std::string(call->arguments[1]);
}

/// Is the variable given a value by a statement that names `source`?
bool isMadeOf(std::string_view text, std::string_view variable, std::string_view source) {
  for (std::size_t at = text.find(variable); at != text.npos; at = text.find(variable, at + 1)) {
    const std::string_view rest = text.substr(at + variable.size());
    const std::size_t end = rest.find(';');
    if (end != rest.npos && trim(rest).starts_with('=') &&
        rest.substr(0, end).find(source) != rest.npos)
      return true;
  }
  return false;
}

/// GL allows an invocation to read the one texel that it is going to write (section 9.3.1), and packs
/// blend by hand that way.
bool mayReadOwnTexel(const WordPlace& place) {
  constexpr std::string_view kPixel = "gl_FragCoord";
  const std::string_view text = place.stage->text.text;
  const auto coordinates = coordinatesAt(text, place);
  // Whoever hands the sampler on may do anything with it.
  if (!coordinates) return text.find(kPixel) != text.npos;
  if (coordinates->find(kPixel) != std::string::npos) return true;
  bool found = false;
  forEachWord(*coordinates, [&](std::string_view word) {
    found = found || isMadeOf(text.substr(0, place.offset), word, kPixel);
  });
  return found;
}

void checkFeedbackOf(const FrameView& frame, const FramePass& pass, Diagnostics& diagnostics) {
  for (const BufferUse& use : pass.uses) {
    if (use.buffer.image || !draws(pass, use)) continue;
    const bool shadow = pass.isShadowGroup();
    if (pass.readsAlt(shadow, use.buffer.index) != pass.writesAlt(use.buffer.index)) continue;
    const auto places = findUses(*pass.program, false, use.name);
    if (places.empty()) continue;
    const auto other = std::ranges::find_if_not(places, mayReadOwnTexel);
    const bool own = other == places.end();
    const std::string title = titleOf(use);
    diagnostics.push_back(diagnosticAt(
        frame.pack, own ? Severity::Note : Severity::Warning, "target-feedback",
        own ? places.front() : *other,
        fmt::format(
            "{} samples {} while it draws to it: geometry programs read and draw to the same "
            "side, so what is read is undefined",
            pass.name, title),
        fmt::format("copy {} to another buffer first, or draw to another one", title)));
  }
}

/// Iris: IrisSamplers.addRenderTargetSamplers. A sampler that is not bound keeps unit 0, the texture of
/// what is drawn.
void checkUnboundOf(const FrameView& frame, const FramePass& pass, Diagnostics& diagnostics) {
  for (const std::string& name : pass.unbound) {
    const auto place = firstPlace(pass, name);
    if (!place) continue;
    diagnostics.push_back(diagnosticAt(
        frame.pack, Severity::Warning, "target-unbound", *place,
        fmt::format("{} samples {}, which Iris binds in fullscreen programs only: here it is the "
                    "texture of what is drawn, as gtexture is",
                    pass.name, name),
        "write gtexture where the texture is meant; the buffer itself can be read in deferred and "
        "composite programs"));
  }
}

void checkStoresOf(const FrameView& frame, const FramePass& pass, Diagnostics& diagnostics) {
  for (const BufferUse& use : pass.uses) {
    if (!use.buffer.image) continue;
    const bool computes = pass.kind == Kind::Compute;
    if (!imageAccess(*pass.program, computes, use.name).stores) continue;
    const auto place = firstPlace(pass, use.name);
    if (!place) continue;
    const std::string title = titleOf(use);
    if (pass.kind == Kind::Fullscreen && draws(pass, use)) {
      diagnostics.push_back(diagnosticAt(
          frame.pack, Severity::Warning, "target-store-lost", *place,
          fmt::format(
              "{} stores to {} and draws to {}: the image is the side that the flip after it "
              "leaves behind",
              pass.name, use.name, title),
          "store to a buffer that the program does not draw to"));
    }
    const bool sampled =
        std::any_of(pass.uses.begin(), pass.uses.end(), [&](const BufferUse& other) {
          return !other.buffer.image && other.buffer.kind == use.buffer.kind &&
                 other.buffer.index == use.buffer.index;
        });
    if (sampled) {
      diagnostics.push_back(diagnosticAt(
          frame.pack, Severity::Note, "target-store-race", *place,
          fmt::format("{} stores to {} and samples {}, which is the same side: a texel may be read "
                      "before or after it is stored",
                      pass.name, use.name, title),
          "only right when each invocation reads no texel but its own"));
    }
  }
}

/// Functions whose last argument is a level.
constexpr std::array<std::string_view, 2> kLevelFunctions = {"textureLod", "texelFetch"};

/// Does the call read a literal level of at least one?
bool readsLevel(std::string_view text, const WordPlace& place) {
  const std::string_view before = trim(text.substr(0, place.offset));
  if (!before.ends_with('(')) return false;
  const std::string_view head = trim(before.substr(0, before.size() - 1));
  const auto function =
      std::find_if(kLevelFunctions.begin(), kLevelFunctions.end(), [&](std::string_view name) {
        return head.ends_with(name) && (head.size() == name.size() ||
                                        !isWordCharacter(head[head.size() - name.size() - 1]));
      });
  if (function == kLevelFunctions.end()) return false;
  const auto call = callAt(text, head.size());
  if (!call || call->arguments.size() != 3) return false;
  const auto level = parseFloat(call->arguments[2]);
  return level && *level >= 1;
}

void checkLevelsOf(const FrameView& frame, const FramePass& pass, Diagnostics& diagnostics) {
  for (const BufferUse& use : pass.uses) {
    if (use.buffer.image || !use.isColor(false)) continue;
    const bool computes = pass.kind == Kind::Compute;
    const auto reads = [](const WordPlace& at) { return readsLevel(at.stage->text.text, at); };
    // Few texts have such a call: whether it is reached is costlier to find out.
    if (std::ranges::none_of(findWord(*pass.program, computes, use.name), reads)) continue;
    for (const WordPlace& place : findUses(*pass.program, computes, use.name)) {
      if (!reads(place)) continue;
      if (frame.mentions().mipmapped.contains(use.buffer.index)) break;
      diagnostics.push_back(diagnosticAt(
          frame.pack, Severity::Warning, "mipmap-missing", place,
          fmt::format(
              "{} reads a higher level of {}, but no program of the pack has its mipmaps made",
              pass.name, titleOf(use)),
          fmt::format("const bool {}MipmapEnabled = true; in the fragment stage", titleOf(use))));
    }
  }
}

/// Levels stay until the frame ends, so a later reader of the buffer is enough.
void checkUnusedLevels(const FrameView& frame, Diagnostics& diagnostics) {
  const auto& passes = frame.passes;
  for (auto pass = passes.begin(); pass != passes.end(); ++pass) {
    if (pass->program == nullptr || pass->kind == Kind::Compute) continue;
    for (const int index : pass->mipmaps) {
      const bool shadow = pass->isShadowGroup();
      const bool read = std::any_of(pass, passes.end(), [&](const FramePass& later) {
        return std::any_of(later.uses.begin(), later.uses.end(), [&](const BufferUse& use) {
          return use.isColor(shadow) && !use.buffer.image && use.buffer.index == index;
        });
      });
      if (read) continue;
      SourceLocation at = pass->program->directives.drawBuffersAt;
      if (at.file.empty()) at.file = pass->program->folder + "/" + pass->program->name + ".fsh";
      diagnostics.push_back(diagnosticAt(
          frame.pack, Severity::Note, "mipmap-unused", at,
          fmt::format("{} has mipmaps of {}{} made, but no program reads it from here on",
                      pass->name, shadow ? "shadowcolor" : "colortex", index),
          "drop the MipmapEnabled line"));
    }
  }
}

}  // namespace

void checkFeedback(const FrameView& frame, Diagnostics& diagnostics) {
  for (const FramePass& pass : frame.passes)
    if (pass.program != nullptr && pass.isGeometry()) checkFeedbackOf(frame, pass, diagnostics);
}

void checkUnboundTargets(const FrameView& frame, Diagnostics& diagnostics) {
  for (const FramePass& pass : frame.passes)
    if (pass.program != nullptr) checkUnboundOf(frame, pass, diagnostics);
}

void checkImageStores(const FrameView& frame, Diagnostics& diagnostics) {
  for (const FramePass& pass : frame.passes)
    if (pass.program != nullptr) checkStoresOf(frame, pass, diagnostics);
}

void checkMipmaps(const FrameView& frame, Diagnostics& diagnostics) {
  for (const FramePass& pass : frame.passes)
    if (pass.program != nullptr) checkLevelsOf(frame, pass, diagnostics);
  checkUnusedLevels(frame, diagnostics);
}

}  // namespace orris
