// Varyings: what a stage writes against what the next one reads.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/check/interface/declaration_checks.h>
#include <orris/check/interface/glsl_types.h>
#include <orris/check/pack/pack_texts.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using Storage = StageGlobal::Storage;
using Interpolation = StageGlobal::Interpolation;
using Finding = DeclarationReport::Finding;

const char* interpolationName(Interpolation interpolation) {
  constexpr const char* kNames[] = {"smooth", "flat", "noperspective"};
  return kNames[static_cast<std::size_t>(interpolation)];
}

bool isBuiltin(const StageGlobal& global) {
  return global.name.starts_with("gl_") || (global.block && global.type.starts_with("gl_"));
}

/// Stages that see their neighbour's variables as arrays, one element for each vertex.
bool hasVertexArrays(Stage stage, Storage storage) {
  if (stage == Stage::TessControl) return true;
  return storage == Storage::In && (stage == Stage::TessEvaluation || stage == Stage::Geometry);
}

/// A varying without the dimension that counts vertices.
std::vector<std::int64_t> sizesOf(const StageInterface& stage, const StageGlobal& global) {
  std::vector<std::int64_t> sizes = global.arraySizes;
  if (!sizes.empty() && !global.patch && hasVertexArrays(stage.stage->stage, global.storage)) {
    sizes.erase(sizes.begin());
  }
  return sizes;
}

/// Names a variable for people: blocks have no name of their own.
std::string_view spoken(const StageGlobal& global) {
  return global.block ? global.type : global.name;
}

/// One pair of neighbouring stages.
class StagePair {
 public:
  StagePair(const ProgramInterface& program, const StageInterface& from, const StageInterface& to,
            DeclarationReport& report)
      : program_(program), from_(from), to_(to), report_(report) {}

  void check() {
    for (const StageGlobal& in : to_.globals) {
      if (in.storage != Storage::In || isBuiltin(in)) continue;
      const StageGlobal* out = writerOf(in);
      if (out) {
        compare(*out, in);
      } else if (in.used) {
        missing_.push_back(&in);
      }
    }
    for (const StageGlobal* in : missing_) reportMissing(*in, meantBy(*in));
    for (const StageGlobal& out : from_.globals) reportUnread(out);
  }

 private:
  const StageGlobal* writerOf(const StageGlobal& in) const { return find(from_, Storage::Out, in); }

  // Locations on both sides decide; a block is known by its own name, a variable by its name.
  static const StageGlobal* find(const StageInterface& stage, Storage storage,
                                 const StageGlobal& other) {
    const auto matches = [&](const StageGlobal& global) {
      if (global.storage != storage || global.block != other.block) return false;
      if (global.block) return global.type == other.type;
      if (global.layout.location >= 0 && other.layout.location >= 0)
        return global.layout.location == other.layout.location &&
               std::max(global.layout.component, 0) == std::max(other.layout.component, 0);
      return global.name == other.name;
    };
    const auto found = std::find_if(stage.globals.begin(), stage.globals.end(), matches);
    return found == stage.globals.end() ? nullptr : &*found;
  }

  void compare(const StageGlobal& out, const StageGlobal& in) {
    if (in.block) {
      compareMembers(out, in);
    } else if (out.type != in.type || sizesDiffer(sizesOf(from_, out), sizesOf(to_, in))) {
      reportType(out, in);
    } else if (!out.used && in.used) {
      reportUnwritten(out, in);
    }
    if (out.interpolation != in.interpolation && in.used && to_.stage->stage == Stage::Fragment &&
        !in.block && !mayInterpolateAnew()) {
      reportInterpolation(out, in);
    }
  }

  // GLSL asks for the same qualifiers on both sides up to 4.30. Iris keeps the author's number.
  bool mayInterpolateAnew() const {
    constexpr int kFirst = 440;
    return std::min(report_.writtenVersion(from_), report_.writtenVersion(to_)) >= kFirst;
  }

  void compareMembers(const StageGlobal& out, const StageGlobal& in) {
    const bool same = std::equal(out.members.begin(), out.members.end(), in.members.begin(),
                                 in.members.end(), [](const BlockMember& a, const BlockMember& b) {
                                   return a.type == b.type && a.name == b.name;
                                 });
    if (same) return;
    reportBoth("varying-type", Severity::Error, out, in,
               fmt::format("has other members in the {} stage than in the {} stage",
                           stageName(from_.stage->stage), stageName(to_.stage->stage)),
               "declare the block once, in a file that both stages include");
  }

  void reportType(const StageGlobal& out, const StageGlobal& in) {
    const auto outSizes = sizesOf(from_, out), inSizes = sizesOf(to_, in);
    const bool repaired = outSizes.empty() && inSizes.empty() && sameShape(out.type, in.type);
    const std::string hint =
        repaired ? "Iris converts the value, other hosts refuse the program: use one type"
                 : "use one type in both stages";
    reportBoth("varying-type", repaired ? Severity::Warning : Severity::Error, out, in,
               fmt::format("is {} in the {} stage and {} in the {} stage",
                           typeName(out.type, outSizes), stageName(from_.stage->stage),
                           typeName(in.type, inSizes), stageName(to_.stage->stage)),
               hint);
  }

  void reportInterpolation(const StageGlobal& out, const StageGlobal& in) {
    reportBoth("varying-interpolation", Severity::Warning, out, in,
               fmt::format("is {} in the {} stage and {} in the {} stage",
                           interpolationName(out.interpolation), stageName(from_.stage->stage),
                           interpolationName(in.interpolation), stageName(to_.stage->stage)),
               "drivers refuse this below #version 440: use one qualifier in both stages");
  }

  void reportBoth(const char* id, Severity severity, const StageGlobal& out, const StageGlobal& in,
                  const std::string& what, const std::string& hint) {
    report_.addPair({from_, out.place}, {to_, in.place},
                    {severity, id, fmt::format("'{}' {}", spoken(in), what), hint, {note()}});
  }

  void reportMissing(const StageGlobal& in, const StageGlobal* meant) {
    const bool repaired = !in.block && isNumeric(in.type);
    const char* from = stageName(from_.stage->stage);
    // Iris declares it first, so that what the stage assigns arrives.
    const bool assigned = occursAsWord(from_.stage->text.text, in.name);
    Finding finding{
        repaired ? Severity::Warning : Severity::Error,
        "varying-missing",
        fmt::format("'{}' is read here, and the {} stage does not declare it", spoken(in), from),
        repaired ? fmt::format("Iris {}, other hosts refuse the program: declare it in the {} stage",
                               assigned ? "declares it there"
                               : zeroedOnce() ? "makes it zero for the first EmitVertex()"
                                              : "makes it zero",
                               from)
                 : fmt::format("declare it in the {} stage", from),
        {note()}};
    if (meant) return reportRenamed(in, *meant, std::move(finding));
    if (const std::string place = otherDeclaration(in); !place.empty())
      finding.notes.push_back(fmt::format("{} declares it for other options or programs", place));
    report_.add(to_, in.place, std::move(finding));
  }

  /// Iris sets it at the start of main(), and after EmitVertex() all outputs are undefined (GLSL 8.15).
  bool zeroedOnce() const { return from_.stage->stage == Stage::Geometry; }

  /// One finding for both names: at the one that is wrong, where the stages say which, else at the reader.
  void reportRenamed(const StageGlobal& in, const StageGlobal& out, Finding finding) {
    const bool wrongOut = occursAsWord(from_.stage->text.text, in.name) &&
                          !occursAsWord(to_.stage->text.text, out.name);
    finding.hint = fmt::format("{}: use one name",
                               isNumeric(in.type)
                                   ? "Iris makes it zero, other hosts refuse the program"
                                   : "the stages do not link");
    if (wrongOut) {
      finding.message = fmt::format("'{}' is read in the {} stage, and the {} stage declares '{}'",
                                    in.name, stageName(to_.stage->stage),
                                    stageName(from_.stage->stage), out.name);
      addPlace(finding, to_, in, fmt::format("where '{}' is read", in.name));
      return report_.add(from_, out.place, std::move(finding));
    }
    addPlace(finding, from_, out, fmt::format("'{}', which is not read", out.name));
    report_.add(to_, in.place, std::move(finding));
  }

  static void addPlace(Finding& finding, const StageInterface& stage, const StageGlobal& global,
                       std::string message) {
    const SourceLocation at = stage.stage->text.locate(global.place.line, global.place.column);
    if (!at.file.empty()) finding.related.push_back({at, std::move(message)});
  }

  /// The first line of the earlier stage's files that declares an output of that name, in a branch that
  /// is not taken; "" for none.
  std::string otherDeclaration(const StageGlobal& in) const {
    const auto& files = report_.folder.pack.files;
    for (const IncludeSite& site : from_.stage->text.sites) {
      const auto file = files.find(site.file);
      if (file == files.end()) continue;
      for (std::size_t i = 0; i < file->second.size(); ++i) {
        const std::string_view line = trim(file->second[i]);
        bool output = false, named = false;
        forEachWord(line, [&](std::string_view word) {
          output = output || word == "out" || word == "varying";
          named = named || word == spoken(in);
        });
        if (output && named && !line.starts_with("//"))
          return fmt::format("{}:{}", site.file, i + 1);
      }
    }
    return "";
  }

  void reportUnwritten(const StageGlobal& out, const StageGlobal& in) {
    report_.add(
        from_, out.place,
        {writtenInSomeBranch(out) ? Severity::Note : Severity::Warning,
         "varying-unwritten",
         fmt::format("'{}' is never written, and the {} stage reads it", spoken(out),
                     stageName(to_.stage->stage)),
         zeroedOnce() ? "Iris makes it zero for the first EmitVertex(), then it is undefined"
                      : "Iris makes it zero, elsewhere its value is undefined",
         {note(), fmt::format("read in the {} stage, declared at {}", stageName(to_.stage->stage),
                              DeclarationReport::placeName(to_, in.place))}});
  }

  /// Do the files of the writing stage write it under other options, or in another folder?
  bool writtenInSomeBranch(const StageGlobal& out) const {
    const auto& sites = from_.stage->text.sites;
    const auto& files = report_.folder.pack.files;
    const auto compiled = compiledLines();
    return std::any_of(sites.begin(), sites.end(), [&](const IncludeSite& site) {
      const auto file = files.find(site.file);
      if (file == files.end()) return false;
      for (std::size_t i = 0; i < file->second.size(); ++i) {
        const std::string& line = file->second[i];
        // What the function does with it is known only where it is compiled.
        const bool mayWrite = !compiled.contains({site.file, int(i) + 1}) && isArgument(line, out.name);
        if (mayWrite || assigns(line, out.name)) return true;
      }
      return false;
    });
  }

  std::set<std::pair<std::string_view, int>> compiledLines() const {
    const MappedText& text = from_.stage->text;
    std::set<std::pair<std::string_view, int>> lines;
    for (const auto& segments : text.lines) {
      for (const MappedText::Segment& segment : segments) {
        if (segment.origin.site >= 0)
          lines.insert({text.sites[std::size_t(segment.origin.site)].file, segment.origin.line});
      }
    }
    return lines;
  }

  void reportUnread(const StageGlobal& out) {
    if (out.storage != Storage::Out || isBuiltin(out) || !out.used) return;
    const StageGlobal* in = find(to_, Storage::In, out);
    if (in && in->used) return;
    if (paired_.contains(&out) || hostMadeFrom()) return;
    report_.add(from_, out.place,
                {Severity::Note,
                 "varying-unread",
                 fmt::format("'{}' is written, and the {} stage does not read it", spoken(out),
                             stageName(to_.stage->stage)),
                 "",
                 {note()}});
  }

  /// What the earlier stage declares, the next one does not, and `in` was meant to be: a slip away, or
  /// the only one of its type that is written, where `in` is the only one of it that is read.
  const StageGlobal* meantBy(const StageGlobal& in) {
    std::vector<const StageGlobal*> likely;
    std::vector<std::string> names;
    for (const StageGlobal& out : from_.globals) {
      if (out.storage != Storage::Out || isBuiltin(out) || !isLike(in, out) ||
          find(to_, Storage::In, out) || hostMadeFrom())
        continue;
      likely.push_back(&out);
      names.emplace_back(out.name);
    }
    const std::string slip = likelyMeant(in.name, names);
    const auto rivals = std::ranges::count_if(
        missing_, [&](const StageGlobal* other) { return other->type == in.type; });
    const bool alone = likely.size() == 1 && rivals == 1 && likely.front()->used &&
                       otherDeclaration(in).empty();
    const auto found = std::ranges::find(names, alone ? names.front() : slip);
    if (found == names.end()) return nullptr;
    const StageGlobal* meant = likely[std::size_t(found - names.begin())];
    return paired_.insert(meant).second ? meant : nullptr;
  }

  bool isLike(const StageGlobal& in, const StageGlobal& out) const {
    return !in.block && !out.block && in.type == out.type && in.layout.location < 0 &&
           !sizesDiffer(sizesOf(from_, out), sizesOf(to_, in));
  }

  // Nobody can change the stage that the host makes for a lone fragment stage.
  bool hostMadeFrom() const {
    const auto& sites = from_.stage->text.sites;
    return sites.empty() || !report_.folder.pack.files.contains(sites.front().file);
  }

  std::string note() const { return "in " + program_.name(); }

  const ProgramInterface& program_;
  const StageInterface& from_;
  const StageInterface& to_;
  DeclarationReport& report_;
  std::vector<const StageGlobal*> missing_;  ///< read by the next stage, written by none
  std::set<const StageGlobal*> paired_;      ///< reported beside one that is missing
};

}  // namespace

void checkVaryings(const ProgramInterface& program, DeclarationReport& report) {
  for (std::size_t i = 1; i < program.stages.size(); ++i) {
    StagePair(program, program.stages[i - 1], program.stages[i], report).check();
  }
}

}  // namespace orris
