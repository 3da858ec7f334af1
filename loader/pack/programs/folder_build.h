// One program folder of a pack under certain option values: which programs there are, and each of
// them built on demand.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <orris/pack/mods/mods.h>
#include <orris/pack/options/live_options.h>
#include <orris/pack/programs/program_builder.h>
#include <orris/pack/properties/pack_properties.h>

namespace orris {

/// A line that a file does not have: an #include of `target`, or else `text`.
struct AddedLine {
  std::string file;
  int line = 0;          ///< of `file`, before which it would stand
  std::string target{};  ///< pack path
  std::string text{};
};

class FolderBuild {
 public:
  /// `similar`, a build of the same files with other values, lends its properties if the values that
  /// differ leave them as they are. `irisTexts` and `live` as in LoadRequest. Nothing is built yet.
  FolderBuild(std::shared_ptr<const PackFiles> files, std::string folder, OptionValues values,
              const MacroDefinitions& environment, bool irisTexts,
              const FolderBuild* similar = nullptr, const std::set<std::string>& live = {});
  /// The programs of another mod, as if it were there. `uniformTypes` as in LoadRequest.
  FolderBuild(const FolderBuild& host, const ModFamily& mod, const MacroDefinitions& environment,
              const std::map<std::string, std::string>& uniformTypes,
              const FolderBuild* similar = nullptr);

  const PackFiles& files() const { return *files_; }
  const std::shared_ptr<const PackFiles>& sharedFiles() const { return files_; }
  const std::string& folder() const { return folder_; }
  const ModFamily* mod() const { return mod_; }  ///< nullptr: the host's own programs
  const OptionValues& values() const { return values_; }
  /// As the texts have them: a live option is the name of its uniform.
  const OptionValues& textValues() const { return textValues_; }
  bool irisTexts() const { return irisTexts_; }
  const std::string& preludeOfVoxy() const { return voxyPrelude_; }  ///< stands before the code of Voxy's programs
  const PackProperties& properties() const { return *properties_; }
  /// Enabled programs in frame order, then name.
  const std::vector<ProgramEntry>& programs() const { return programs_; }
  const ProgramEntry* entryNamed(std::string_view program) const;  ///< nullptr: none is enabled
  const std::vector<std::string>& disabled() const { return disabled_; }
  /// Lines of a file of the include graph with the values applied, nullptr for another file.
  const FileLines* lines(const std::string& file) const;

  /// From its files to texts that compile. Safe to call from several threads.
  ProgramSource build(const ProgramEntry& entry) const;
  /// As it would be with one more line, an #include of whatever file of the pack for one; the same as
  /// build() when a file would include itself. What nobody judges is left out (BuildContext::judgedOnly).
  ProgramSource buildWith(const ProgramEntry& entry, const AddedLine& added) const;
  /// A hash of all that buildWith() makes texts and diagnostics from, before it makes them; nullopt when
  /// it is the same as build().
  std::optional<std::uint64_t> hashWith(const ProgramEntry& entry, const AddedLine& added) const;
  /// The two halves of build() (pack/programs/program_builder.h).
  PreprocessedPart buildPart(const ProgramEntry& entry, std::size_t part) const;
  ProgramSource finish(const ProgramEntry& entry, std::vector<PreprocessedPart> parts) const;

 private:
  void readProperties(const MacroDefinitions& environment, const FolderBuild* similar);
  bool reachesAny(const ProgramEntry& entry, const std::set<std::string>& wanted) const;
  void listAll();
  void listVoxy(const std::map<std::string, std::string>& uniformTypes);
  BuildContext context(const FileLookup& lookup) const { return context(files_->graph, lookup); }
  BuildContext context(const IncludeGraph& graph, const FileLookup& lookup) const;
  bool isEnabled(const std::string& program, const Profile* profile);

  std::shared_ptr<const PackFiles> files_;
  std::string folder_;
  OptionValues values_, textValues_;
  std::vector<LiveUniform> live_;
  bool irisTexts_ = false;
  const ModFamily* mod_ = nullptr;
  std::string voxyPrelude_;
  std::shared_ptr<const PackProperties> properties_;
  std::map<std::string, FileLines> edited_;  ///< files that the values change
  std::vector<ProgramEntry> programs_;
  std::vector<std::string> disabled_;
};

/// Names of options whose values differ, sorted.
std::vector<std::string> differingOptions(const OptionSet& options, const OptionValues& a,
                                          const OptionValues& b);
/// Do two sorted lists have a name in common?
bool haveCommonName(const std::vector<std::string>& a, const std::vector<std::string>& b);

}  // namespace orris
