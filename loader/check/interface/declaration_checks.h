// Checks on what programs declare: varyings, names of the contract, outputs, limits of the target.
// Each program is read once for all of them.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include <orris/check/interface/stage_interface.h>
#include <orris/check/pack/pack_checks.h>

namespace orris {

/// Stages that link together, as declared.
struct ProgramInterface {
  const ProgramSource* program = nullptr;
  const ComputeSource* compute = nullptr;  ///< set when it is a compute shader of `program`
  std::vector<StageInterface> stages;
  std::string name() const;  ///< "/world0/composite3"
};

/// Adds located diagnostics, each place and message once.
class DeclarationReport {
 public:
  DeclarationReport(const FolderInput& input, Diagnostics& diagnostics)
      : folder(input), diagnostics_(diagnostics) {}

  struct Finding {
    Severity severity = Severity::Warning;
    std::string id;
    std::string message;
    std::string hint;
    std::vector<std::string> notes;
    std::vector<RelatedPlace> related;
  };
  /// At a place of a final text; nothing is added when the host made the text there.
  void add(const StageInterface& stage, const TextPlace& place, Finding finding);
  /// At a place of the author's.
  void add(const SourceLocation& at, Finding finding);
  /// Of two declarations that do not fit: one finding at the end of all, with the other places as related.
  /// Where one declaration does not fit several, it stands there, else at the second.
  struct Side {
    const StageInterface& stage;
    const TextPlace& place;
  };
  void addPair(const Side& from, const Side& to, const Finding& finding);
  void finishPairs();
  /// The number in the author's #version of the stage, 0 for none. The final text has the host's.
  int writtenVersion(const StageInterface& stage) const;
  /// "/lib/a.glsl:3" of a place in a final text.
  static std::string placeName(const StageInterface& stage, const TextPlace& place);

  const FolderInput& folder;

 private:
  struct Pair {
    Diagnostic from, to;  ///< the same finding at either end
  };
  bool known(const SourceLocation& at, const Finding& finding);
  Diagnostic locateFinding(const StageInterface& stage, const TextPlace& place,
                           Finding finding) const;
  Diagnostics& diagnostics_;
  std::vector<Pair> pairs_;
  std::map<std::string, std::size_t> seen_;  ///< index of the diagnostic
};

void checkDeclarations(const FolderInput& input, Diagnostics& diagnostics);

/// Names, as ProgramUnit has them, of the programs in whose varyings checkDeclarations() finds an error.
std::set<std::string> programsThatDoNotLink(const FolderInput& input);

/// varying-*: what a stage hands to the next.
void checkVaryings(const ProgramInterface& program, DeclarationReport& report);

/// uniform-unknown, attribute-unknown, uniform-type, sampler-type, sampler-format, image-type: names
/// and types that the contract, or the pack's own shaders.properties, gives.
void checkNames(const ProgramInterface& program, DeclarationReport& report);

/// output-*: what a fragment stage writes against its draw buffers.
void checkOutputs(const ProgramInterface& program, DeclarationReport& report);

/// target-limit: counts against the limits of the target.
void checkResourceCounts(const ProgramInterface& program, DeclarationReport& report);

}  // namespace orris
