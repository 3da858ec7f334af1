// Outputs of a fragment stage against RENDERTARGETS or DRAWBUFFERS.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include <orris/check/compile/text_scanner.h>
#include <orris/check/interface/declaration_checks.h>
#include <orris/check/interface/glsl_types.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

using Storage = StageGlobal::Storage;
using Finding = DeclarationReport::Finding;

constexpr int kMostOutputs = 8;

/// Slots that an output takes: [first, first + count).
struct Slots {
  int first = 0;
  int count = 1;
};

/// As the author wrote it: the host gives gl_FragData beside outputs a name of its own.
std::string spokenOutput(const StageGlobal& output) {
  constexpr std::string_view kOfHost = "orris_FragData";
  return output.name.starts_with(kOfHost)
             ? fmt::format("gl_FragData[{}]", output.name.substr(kOfHost.size()))
             : std::string(output.name);
}

class FragmentOutputs {
 public:
  FragmentOutputs(const ProgramInterface& program, const StageInterface& stage,
                  DeclarationReport& report)
      : program_(program), stage_(stage), report_(report) {
    for (const StageGlobal& global : stage.globals) {
      if (global.storage == Storage::Out && !global.block && !global.name.starts_with("gl_"))
        outputs_.push_back(&global);
    }
  }

  void check() {
    checkShared();
    checkAny();
    if (program_.program->group == ProgramGroup::Final) return checkFinal();
    for (const StageGlobal* output : outputs_) checkListed(*output);
    for (const FragDataUse& use : stage_.fragData) checkListed(use);
    reportUnlisted();
    checkWritten();
  }

 private:
  /// nullopt: the driver chooses.
  std::optional<Slots> slotsOf(const StageGlobal& output) const {
    const std::int64_t size = output.arraySizes.empty() ? 1 : output.arraySizes.front();
    const int count = static_cast<int>(std::clamp<std::int64_t>(size, 1, kMostOutputs));
    if (output.layout.location >= 0) return Slots{output.layout.location, count};
    if (outputs_.size() == 1) return Slots{0, count};
    return std::nullopt;
  }

  void checkShared() {
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (overlap(*outputs_[i], *outputs_[k])) reportShared(*outputs_[i], *outputs_[k]);
      }
    }
  }

  bool overlap(const StageGlobal& a, const StageGlobal& b) const {
    if (a.layout.location < 0 || b.layout.location < 0) return false;
    if (std::max(a.layout.index, 0) != std::max(b.layout.index, 0)) return false;
    if (a.layout.component >= 0 || b.layout.component >= 0) return false;
    const Slots first = *slotsOf(a), second = *slotsOf(b);
    return first.first < second.first + second.count && second.first < first.first + first.count;
  }

  void reportShared(const StageGlobal& later, const StageGlobal& earlier) {
    report_.add(stage_, later.place,
                {Severity::Error,
                 "output-overlap",
                 fmt::format("'{}' has the location {}, which '{}' has too", spokenOutput(later),
                             later.layout.location, spokenOutput(earlier)),
                 "give each output a location of its own",
                 {fmt::format("'{}' is declared at {}", spokenOutput(earlier),
                              DeclarationReport::placeName(stage_, earlier.place))}});
  }

  const std::vector<int>& buffers() const { return program_.program->drawBuffers; }

  /// An output that no buffer of the list gets.
  struct Unlisted {
    TextPlace place;
    std::string name;
    int slot = 0;
    bool built = false;  ///< gl_FragData
  };

  void checkListed(const StageGlobal& output) {
    const auto slots = slotsOf(output);
    if (!slots || !output.used) return;
    const int last = slots->first + slots->count - 1;
    written_.insert(slots->first);
    for (int slot = slots->first; slot <= std::min(last, kMostOutputs); ++slot)
      written_.insert(slot);
    if (last < static_cast<int>(buffers().size())) return;
    addUnlisted({output.place, spokenOutput(output), last, false});
  }

  void checkListed(const FragDataUse& use) {
    if (use.index < 0) {
      anyIndex_ = true;
      return;
    }
    written_.insert(use.index);
    if (use.index < static_cast<int>(buffers().size())) return;
    addUnlisted({use.place, fmt::format("gl_FragData[{}]", use.index), use.index, true});
  }

  SourceLocation placeOf(const Unlisted& output) const {
    return stage_.stage->text.locate(output.place.line, output.place.column);
  }

  /// The first use of each in the author's text.
  void addUnlisted(Unlisted output) {
    const bool known = std::ranges::find(unlisted_, output.name, &Unlisted::name) != unlisted_.end();
    if (!known && !placeOf(output).file.empty()) unlisted_.push_back(std::move(output));
  }

  /// All of a program are one finding: they lack one list.
  void reportUnlisted() {
    if (unlisted_.empty()) return;
    const Unlisted& first = unlisted_.front();
    const SourceLocation& directive = program_.program->directives.drawBuffersAt;
    const bool listed = program_.program->directives.drawBuffers.has_value();
    std::vector<RelatedPlace> others;
    for (const Unlisted& output : std::span(unlisted_).subspan(1))
      others.push_back({placeOf(output), output.name + " goes to no buffer either"});
    report_.add(
        stage_, first.place,
        {Severity::Warning,
         "output-unlisted",
         fmt::format("{} is written to no buffer: the program draws to {}",
                     first.built ? first.name : fmt::format("'{}' at location {}", first.name, first.slot),
                     bufferList()),
         hintOfUnlisted(first),
         {listed ? fmt::format("they are listed at {}:{}", directive.file, directive.line)
                 : "without RENDERTARGETS or DRAWBUFFERS these are the buffers"},
         std::move(others)});
  }

  std::string hintOfUnlisted(const Unlisted& first) const {
    const auto place = std::ranges::find(buffers(), first.slot);
    const std::size_t number = std::size_t(place - buffers().begin());
    if (!first.built && place != buffers().end() && !written_.contains(int(number)))
      return fmt::format("locations count places in the list: write layout(location = {})", number);
    return needed() > std::size_t{kMostOutputs}
               ? "number outputs by their place in RENDERTARGETS, from 0: drivers have 8"
               : fmt::format("list {} buffers in RENDERTARGETS, or drop the output", needed());
  }

  std::size_t needed() const {
    std::size_t most = buffers().size();
    for (const int slot : written_) most = std::max(most, static_cast<std::size_t>(slot) + 1);
    return most;
  }

  std::string bufferList() const {
    const ProgramGroup group = program_.program->group;
    const bool shadow = group == ProgramGroup::Shadow || group == ProgramGroup::ShadowComp;
    std::string list;
    for (const int buffer : buffers()) {
      list += fmt::format("{}{}{}", list.empty() ? "" : ", ", shadow ? "shadowcolor" : "colortex",
                          buffer);
    }
    return list.empty() ? "none" : list;
  }

  // Programs may write nothing: those that discard, that work through images and buffers, that only
  // leave a depth, and empty ones.
  void checkAny() {
    constexpr std::string_view kOtherWorks[] = {"discard", "imageStore", "imageAtomic",
                                                "atomic",  "buffer",     "gl_FragDepth"};
    const std::string& text = stage_.stage->text.text;
    const ProgramGroup group = program_.program->group;
    const bool writes =
        !stage_.fragData.empty() ||
        std::ranges::any_of(outputs_, [](const auto* output) { return output->used; });
    if (writes || group == ProgramGroup::Shadow || group == ProgramGroup::ShadowVolume) return;
    if (std::ranges::any_of(kOtherWorks, [&](std::string_view word) {
          return text.find(word) != std::string::npos;
        }))
      return;
    const std::optional<TextPlace> end = endOfWork(text);
    if (!end) return;
    report_.add(stage_, *end,
                {Severity::Warning,
                 "output-none",
                 "main() ends here, and the program has written nothing",
                 "write an output, or remove the program",
                 {"in " + program_.name()}});
  }

  /// The '}' of a main() that assigns something, nullopt for others.
  static std::optional<TextPlace> endOfWork(std::string_view text) {
    TextScanner scanner(text);
    int depth = 0;
    bool inMain = false, assigns = false;
    for (TextToken token = scanner.next(); token.kind != TextToken::Kind::End;
         token = scanner.next()) {
      if (depth == 0 && token.text == "main") inMain = true;
      assigns = assigns || (inMain && token.is('='));
      depth += token.is('{') ? 1 : token.is('}') ? -1 : 0;
      if (!inMain || depth > 0 || !token.is('}')) continue;
      return assigns ? std::optional(TextPlace{token.line, token.column}) : std::nullopt;
    }
    return std::nullopt;
  }

  // Iris: FinalPassRenderer draws to the game's picture, whatever is listed.
  void checkFinal() {
    const ProgramDirectives& directives = program_.program->directives;
    if (!directives.drawBuffers || directives.drawBuffers->size() < 2) return;
    report_.add(directives.drawBuffersAt,
                {Severity::Warning,
                 "output-unwritten",
                 "final draws to the screen only: the buffers listed get nothing",
                 "drop the list, and write what is to be kept in a composite pass",
                 {"in " + program_.name()}});
  }

  // A program that writes nothing at all is left to checkAny().
  void checkWritten() {
    const ProgramDirectives& directives = program_.program->directives;
    if (!directives.drawBuffers || written_.empty() || anyIndex_ || chosenByDriver()) return;
    std::vector<std::string> unwritten;
    Severity severity = Severity::Note;
    for (std::size_t slot = 0; slot < buffers().size(); ++slot) {
      if (written_.contains(static_cast<int>(slot))) continue;
      if (!writtenInSomeBranch(slot)) severity = Severity::Warning;
      unwritten.push_back(std::to_string(buffers()[slot]));
    }
    if (unwritten.empty()) return;
    const bool one = unwritten.size() == 1;
    report_.add(
        directives.drawBuffersAt,
        {severity,
         "output-unwritten",
         one ? fmt::format("buffer {} is listed, and the program writes nothing to it",
                           unwritten.front())
             : fmt::format("buffers {} are listed, and the program writes nothing to them",
                           joinNames(unwritten)),
         one ? "its contents become undefined: drop it from the list, or write it"
             : "their contents become undefined: drop them from the list, or write them",
         {"in " + program_.name()}});
  }

  /// Do the files of the stage name the output under other options, or in another folder?
  bool writtenInSomeBranch(std::size_t slot) const {
    const std::string index = std::to_string(slot);
    const std::string forms[] = {"gl_FragData[" + index + "]", "location=" + index,
                                 "outColor" + index};
    const auto names = [&](std::string line) {
      std::erase_if(line, [](char c) { return c == ' ' || c == '\t'; });
      return std::any_of(std::begin(forms), std::end(forms), [&](const std::string& form) {
        const std::size_t at = line.find(form);
        if (at == std::string::npos) return false;
        const std::size_t end = at + form.size();
        return end >= line.size() || !isWordCharacter(line[end]);
      });
    };
    const auto& files = report_.folder.pack.files;
    const auto& sites = stage_.stage->text.sites;
    return std::any_of(sites.begin(), sites.end(), [&](const IncludeSite& site) {
      const auto file = files.find(site.file);
      return file != files.end() && std::any_of(file->second.begin(), file->second.end(), names);
    });
  }

  bool chosenByDriver() const {
    return std::any_of(outputs_.begin(), outputs_.end(), [&](const StageGlobal* output) {
      return output->used && !slotsOf(*output);
    });
  }

  const ProgramInterface& program_;
  const StageInterface& stage_;
  DeclarationReport& report_;
  std::vector<const StageGlobal*> outputs_;
  std::set<int> written_;
  std::vector<Unlisted> unlisted_;
  bool anyIndex_ = false;
};

}  // namespace

void checkOutputs(const ProgramInterface& program, DeclarationReport& report) {
  for (const StageInterface& stage : program.stages) {
    if (stage.stage->stage == Stage::Fragment) FragmentOutputs(program, stage, report).check();
  }
}

}  // namespace orris
