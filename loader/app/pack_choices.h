// Which option values a running view uses: the command line's, the option file's, and what the
// world's events have set since.
#pragma once

#include <string>

#include "app/common.h"
#include "app/report.h"
#include "frame/render_session.h"

namespace orris {

/// Name of a pack's folder or zip.
std::string packNameOf(const std::string& packPath);
/// The option file that belongs to a pack: beside it, named like it with ".txt".
std::string optionFileOf(const std::string& packPath);

class PackChoices {
 public:
  /// Without --settings the pack's own option file counts, if there is one.
  explicit PackChoices(const PackOptions& options);

  const std::string& optionFile() const { return optionFile_; }
  /// The command line's choices and, if wanted, those of the option file as it is now. nullopt:
  /// reported.
  std::optional<OptionValues> read(const PackOpener& openPack, const LoadRequest& request,
                                   bool withOptionFile, Report& report) const;
  /// Says that a pack now runs with these values, as read() gave them.
  void accept(const OptionValues& values) { accepted_ = values; }
  /// What `current` holds beyond the values accepted last: set by events.
  OptionValues setSince(const OptionValues& current) const;

 private:
  OptionValues commandLine_;
  std::string optionFile_;
  bool required_;
  OptionValues accepted_;
};

}  // namespace orris
