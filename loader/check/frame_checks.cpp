#include "check/frame_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "check/buffer_mentions.h"
#include "check/frame_passes.h"
#include "check/program_text.h"
#include "pack/include_graph.h"

namespace orris {
namespace {

using Kind = FramePass::Kind;

std::string bufferTitle(bool shadow, int index) {
  return fmt::format("{}{}", shadow ? "shadowcolor" : "colortex", index);
}

bool isShadowColor(const BufferName& buffer) {
  return buffer.kind == BufferName::Kind::ShadowColor;
}

bool isColor(const BufferName& buffer) {
  return buffer.kind == BufferName::Kind::Color || isShadowColor(buffer);
}

/// Looks through the files only when a check is about to speak.
class LazyMentions {
 public:
  explicit LazyMentions(const ShaderPack& pack) : pack_(pack) {}
  const BufferMentions& get() {
    if (!mentions_) mentions_ = findBufferMentions(pack_);
    return *mentions_;
  }

 private:
  const ShaderPack& pack_;
  std::optional<BufferMentions> mentions_;
};

class UnreadCheck {
 public:
  UnreadCheck(const FolderInput& input, Diagnostics& diagnostics)
      : pack_(input.pack),
        passes_(framePasses(input.pack, input.schedule)),
        mentions_(input.pack),
        diagnostics_(diagnostics) {}

  void run() {
    for (const FramePass& pass : passes_)
      for (const BufferUse& use : buffersUsed(pack_, pass))
        if (isColor(use.buffer)) used_.insert({isShadowColor(use.buffer), use.buffer.index});
    for (const FramePass& pass : passes_) {
      // Without a directive the host chose the buffers, not the author.
      if (pass.program == nullptr || !pass.program->directives.drawBuffers) continue;
      for (const int index : pass.writes) checkBuffer(pass, index);
    }
  }

 private:
  void checkBuffer(const FramePass& pass, int index) {
    const bool shadow = pass.isShadowGroup();
    // colortex0 is what every sampler name that nobody binds reads, and what a frame without a final
    // program shows.
    if ((!shadow && index == 0) || pass.kind == Kind::Present) return;
    if (!used_.insert({shadow, index}).second) return;
    const BufferMentions& m = mentions_.get();
    const bool mentioned = m.pasted || (shadow ? m.shadowColor : m.color).contains(index) ||
                           (shadow ? m.shadowImages : m.colorImages).contains(index);
    if (mentioned) return;
    diagnostics_.push_back(diagnosticAt(
        pack_, Severity::Warning, "target-unread", pass.program->directives.drawBuffersAt,
        fmt::format("{} draws to {}, but no program of the pack reads it", pass.name,
                    bufferTitle(shadow, index)),
        "leave it out of the list, or read it"));
  }

  const ShaderPack& pack_;
  const std::vector<FramePass> passes_;
  LazyMentions mentions_;
  std::set<std::pair<bool, int>> used_;
  Diagnostics& diagnostics_;
};

/// Follows what is in each side of each buffer through one frame.
class UnwrittenCheck {
 public:
  UnwrittenCheck(const FolderInput& input, Diagnostics& diagnostics)
      : pack_(input.pack),
        schedule_(input.schedule),
        passes_(framePasses(input.pack, input.schedule)),
        mentions_(input.pack),
        diagnostics_(diagnostics) {}

  void run() {
    for (const FramePass& pass : passes_) {
      const std::vector<BufferUse> uses = buffersUsed(pack_, pass);
      for (const BufferUse& use : uses)
        if (isColor(use.buffer) && !use.buffer.image) checkRead(pass, use);
      for (const BufferUse& use : uses)
        if (isColor(use.buffer) && use.buffer.image && !pass.setup)
          fill(isShadowColor(use.buffer), use.buffer.index,
               pass.readsAlt(isShadowColor(use.buffer), use.buffer.index), pass.name);
      for (const int index : pass.writes)
        fill(pass.isShadowGroup(), index, pass.writesAlt(index), pass.name);
    }
    for (const auto& [buffer, state] : sides_) reportFirst(state);
  }

 private:
  struct Read {
    const FramePass* pass = nullptr;
    BufferUse use;
    std::string why, hint;  ///< empty: the read finds something
  };

  struct Sides {
    std::array<std::string, 2> writer;  ///< of main and alt in this frame, "" for none
    std::vector<Read> reads;
  };

  Sides& sides(bool shadow, int index) { return sides_[{shadow, index}]; }

  void fill(bool shadow, int index, bool alt, const std::string& writer) {
    sides(shadow, index).writer[alt ? 1 : 0] = writer;
  }

  void checkRead(const FramePass& pass, const BufferUse& use) {
    if (pass.program == nullptr) return;
    Sides& state = sides(isShadowColor(use.buffer), use.buffer.index);
    Read& read = state.reads.emplace_back(Read{&pass, use, {}, {}});
    const bool alt = pass.readsAlt(isShadowColor(use.buffer), use.buffer.index);
    if (state.writer[alt ? 1 : 0].empty()) judge(read, state, alt);
  }

  void judge(Read& read, const Sides& state, bool alt) {
    const bool shadow = isShadowColor(read.use.buffer);
    const int index = read.use.buffer.index;
    const BufferMentions& m = mentions_.get();
    if (m.pasted || hasImplicitWriter(shadow, index)) return;
    if ((shadow ? m.shadowImages : m.colorImages).contains(index)) return;
    if (!m.drawnAnywhere.contains(index)) {
      read.why = "but no program of the pack draws to it";
      read.hint = "list it in a RENDERTARGETS comment of the program that fills it";
      return;
    }
    const TargetPlan* plan = schedule_.target(shadow, index);
    const bool kept = (shadow ? m.keptShadow : m.keptColor).contains(index);
    if (plan != nullptr && plan->clear && !kept) judgeOrder(read, state, alt);
  }

  // Programs without a directive draw to colortex0, in the shadow pass to shadowcolor0 and 1.
  static bool hasImplicitWriter(bool shadow, int index) {
    return index == 0 || (shadow && index == 1);
  }

  void judgeOrder(Read& read, const Sides& state, bool alt) {
    const std::string title = bufferTitle(isShadowColor(read.use.buffer), read.use.buffer.index);
    const std::string& other = state.writer[alt ? 0 : 1];
    if (!other.empty()) {
      read.why =
          fmt::format("whose {} side nothing has drawn to in this frame: {} drew to the {} side",
                      alt ? "alt" : "main", other, alt ? "main" : "alt");
      read.hint = fmt::format("flip.<program>.{} decides which side the next program reads", title);
    } else if (!drawnEarlierInSomeBranch(*read.pass, read.use.buffer.index)) {
      read.why =
          "before any program of the frame draws to it, and it is cleared at the start of each "
          "frame";
      read.hint =
          fmt::format("const bool {}Clear = false; keeps the image of the last frame", title);
    }
  }

  static int rankOf(ProgramGroup group) {
    switch (group) {
      case ProgramGroup::Setup:
      case ProgramGroup::Begin:
        return 0;
      case ProgramGroup::Shadow:
        return 1;
      case ProgramGroup::ShadowComp:
        return 2;
      case ProgramGroup::Prepare:
        return 3;
      case ProgramGroup::Deferred:
        return 5;
      case ProgramGroup::Composite:
        return 6;
      case ProgramGroup::Final:
        return 7;
      default:
        return 4;
    }
  }

  /// Does a program that runs earlier, enabled or not, list the buffer in some branch? That of another
  /// folder counts: packs share code between dimensions that do not all fill its buffers. Geometry
  /// programs count as earlier than each other: what runs first depends on the world.
  bool drawnEarlierInSomeBranch(const FramePass& reader, int index) {
    if (!graph_) {
      Diagnostics ignored;
      graph_ = readIncludeGraph(*pack_.source, programFiles(), ignored);
    }
    const int rank = rankOf(reader.group);
    for (const std::string& path : programFiles()) {
      const auto file = parseProgramFile(path);
      const int other = rankOf(file->group);
      const bool earlier =
          other < rank ||
          (other == rank && (other == 4 || other == 1 || file->index < indexOf(reader)));
      if (earlier && listsBuffer(path, index)) return true;
    }
    return false;
  }

  static int indexOf(const FramePass& pass) { return pass.program ? pass.program->index : 0; }

  std::vector<std::string> programFiles() const {
    std::vector<std::string> files;
    for (const std::string& path : pack_.source->files())
      if (parseProgramFile(path)) files.push_back(path);
    return files;
  }

  bool listsBuffer(const std::string& path, int index) {
    const auto& drawn = mentions_.get().drawn;
    for (const std::string& file : reachableFiles(*graph_, path))
      if (const auto found = drawn.find(file);
          found != drawn.end() && found->second.contains(index))
        return true;
    return false;
  }

  /// At most one report for each buffer: the first wrong read whose place is not right elsewhere.
  void reportFirst(const Sides& state) {
    const bool wrong = std::any_of(state.reads.begin(), state.reads.end(),
                                   [](const Read& read) { return !read.why.empty(); });
    if (!wrong) return;
    std::set<std::pair<std::string, int>> rightPlaces;
    for (const Read& read : state.reads)
      if (read.why.empty())
        for (const WordPlace& place : placesOf(read)) {
          const SourceLocation at = locationOf(place);
          rightPlaces.insert({at.file, at.line});
        }
    for (const Read& read : state.reads) {
      if (read.why.empty()) continue;
      for (const WordPlace& place : placesOf(read)) {
        const SourceLocation at = locationOf(place);
        if (rightPlaces.contains({at.file, at.line})) continue;
        return report(read, place);
      }
    }
  }

  /// Where the pass names the buffer outside of declarations.
  static std::vector<WordPlace> placesOf(const Read& read) {
    auto places = findWord(*read.pass->program, read.pass->kind == Kind::Compute, read.use.name);
    std::erase_if(places, isDeclaration);
    return places;
  }

  void report(const Read& read, const WordPlace& place) {
    diagnostics_.push_back(diagnosticAt(
        pack_, Severity::Warning, "target-unwritten", place,
        fmt::format("{} reads {}, {}", read.pass->name,
                    bufferTitle(isShadowColor(read.use.buffer), read.use.buffer.index), read.why),
        read.hint));
  }

  const ShaderPack& pack_;
  const Schedule& schedule_;
  const std::vector<FramePass> passes_;
  LazyMentions mentions_;
  std::optional<IncludeGraph> graph_;
  std::map<std::pair<bool, int>, Sides> sides_;
  Diagnostics& diagnostics_;
};

}  // namespace

void checkTargetsRead(const FolderInput& input, Diagnostics& diagnostics) {
  UnreadCheck(input, diagnostics).run();
}

void checkTargetsWritten(const FolderInput& input, Diagnostics& diagnostics) {
  UnwrittenCheck(input, diagnostics).run();
}

}  // namespace orris
