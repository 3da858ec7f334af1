#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include <orris/check/compile/program_text.h>
#include <orris/check/frame/frame_checks.h>
#include <orris/pack/files/include_graph.h>

namespace orris {
namespace {

using Kind = FramePass::Kind;

/// Follows what is in each side of each buffer through one frame.
class UnwrittenCheck {
 public:
  UnwrittenCheck(const FrameView& frame, Diagnostics& diagnostics)
      : frame_(frame), diagnostics_(diagnostics) {}

  void run() {
    for (const FramePass& pass : frame_.passes) {
      for (const BufferUse& use : pass.uses)
        if (use.isTarget() && !use.buffer.image) checkRead(pass, use);
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
    Sides& state = sides(use.inShadowMap(), use.buffer.index);
    Read& read = state.reads.emplace_back(Read{&pass, use, {}, {}});
    const bool alt = pass.readsAlt(use.inShadowMap(), use.buffer.index);
    if (state.writer[alt ? 1 : 0].empty()) judge(read, state, alt);
  }

  void judge(Read& read, const Sides& state, bool alt) {
    const bool shadow = read.use.inShadowMap();
    const int index = read.use.buffer.index;
    const BufferMentions& m = frame_.mentions();
    if (m.pasted || hasImplicitWriter(shadow, index)) return;
    // Whoever stores to it as an image may fill it at any time.
    if ((shadow ? m.shadowImages : m.colorImages).contains(index)) return;
    if (!m.drawnAnywhere.contains(index)) {
      read.why = "but no program of the pack draws to it";
      read.hint = "list it in a RENDERTARGETS comment of the program that fills it";
      return;
    }
    const TargetPlan* plan = frame_.schedule.target(shadow, index);
    const bool kept = (shadow ? m.keptShadow : m.keptColor).contains(index);
    if (plan != nullptr && plan->clear && !kept) judgeOrder(read, state, alt);
  }

  // Programs without a directive draw to colortex0, in the shadow pass to shadowcolor0 and 1.
  static bool hasImplicitWriter(bool shadow, int index) {
    return index == 0 || (shadow && index == 1);
  }

  void judgeOrder(Read& read, const Sides& state, bool alt) {
    const std::string title = targetTitle(read.use.inShadowMap(), read.use.buffer.index);
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
      graph_ = readIncludeGraph(*frame_.pack.source, programFiles(), ignored);
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
    for (const std::string& path : frame_.pack.source->files())
      if (parseProgramFile(path)) files.push_back(path);
    return files;
  }

  bool listsBuffer(const std::string& path, int index) {
    const auto& drawn = frame_.mentions().drawn;
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
    return findUses(*read.pass->program, read.pass->kind == Kind::Compute, read.use.name);
  }

  void report(const Read& read, const WordPlace& place) {
    diagnostics_.push_back(diagnosticAt(
        frame_.pack, Severity::Warning, "target-unwritten", place,
        fmt::format("{} reads {}, {}", read.pass->name,
                    targetTitle(read.use.inShadowMap(), read.use.buffer.index), read.why),
        read.hint));
  }

  const FrameView& frame_;
  std::optional<IncludeGraph> graph_;
  std::map<std::pair<bool, int>, Sides> sides_;
  Diagnostics& diagnostics_;
};

}  // namespace

void checkTargetsWritten(const FrameView& frame, Diagnostics& diagnostics) {
  UnwrittenCheck(frame, diagnostics).run();
}

}  // namespace orris
