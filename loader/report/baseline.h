// Known problems of an old pack, kept in a file so that only new ones are reported.
//
// A problem is known by its fingerprint: id, file, message and the text of its line, but not the
// line's number, so that edits above do not revive it. The same fingerprint n times in the file
// allows it n times.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// 16 hex digits. Blanks of the source line and line numbers inside the message do not count.
std::string fingerprintOf(const Diagnostic& diagnostic);

class Baseline {
 public:
  /// Reads what formatBaseline() wrote; nullopt and located diagnostics when the text is none.
  static std::optional<Baseline> parse(const std::string& path, std::string_view text,
                                       Diagnostics& diagnostics);

  /// Whether the problem is known; takes it off the list.
  bool take(const std::string& fingerprint);
  int taken() const { return taken_; }
  /// Entries that nothing took: problems that are gone.
  int left() const;

 private:
  std::map<std::string, int> counts_;
  int taken_ = 0;
};

/// One line for each distinct problem, sorted by file, id and message: "FINGERPRINT COUNT SEVERITY
/// ID FILE: MESSAGE". Only fingerprint and count are read again, the rest is for people.
std::string formatBaseline(const std::vector<Diagnostic>& problems);

}  // namespace orris
