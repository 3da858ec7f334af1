// Located messages: how every problem a user can cause is reported.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

enum class Severity { Note, Warning, Error };
const char* severityName(Severity severity);  ///< "note", "warning", "error"

/// What the game does about a problem (Iris), where that is known.
enum class Effect { Unstated, RefusesPack, RefusesProgram, IgnoresLine };
const char* effectName(Effect effect);  ///< "refuses-pack", "refuses-program", "ignores-line", ""
Effect effectNamed(std::string_view name);

/// A place in a file as its author sees it. `file` is a pack path ("/lib/sky.glsl") or the path the
/// user typed; `line` and `column` start at 1, 0 means unknown.
struct SourceLocation {
  std::string file;
  int line = 0;
  int column = 0;
  bool operator==(const SourceLocation&) const = default;
};

/// Another place that a problem is about: the other stage, the other end of a block.
struct RelatedPlace {
  SourceLocation at;
  std::string message;
  bool operator==(const RelatedPlace&) const = default;
};

/// An edit of one line, after which a mistake is gone: `text` stands before the line, or in its place.
struct LineEdit {
  std::string file;
  int line = 0;
  std::string text;
  bool replaces = false;
  bool operator==(const LineEdit&) const = default;
};

/// One problem. `message` says what was found and expected; `hint` says what to do (may be empty).
struct Diagnostic {
  Severity severity = Severity::Error;
  std::string id;  ///< stable kebab-case identifier, "include-missing"
  SourceLocation at;
  std::string message;
  std::vector<SourceLocation> includedFrom;  ///< innermost #include first
  std::string sourceLine;                    ///< the author's line, for the caret (may be empty)
  std::vector<std::string> notes;            ///< macro or option that led here
  std::string hint;
  Effect effect = Effect::Unstated;  ///< stated in `message`, too: withEffect()
  std::vector<RelatedPlace> related{};
  /// Of a mistake that makes a compiler misread what comes after it: how to read the rest as meant.
  std::optional<LineEdit> repair{};
};

using Diagnostics = std::vector<Diagnostic>;

bool hasErrors(const Diagnostics& diagnostics);
/// Is there one for which Iris refuses the whole pack?
bool refusesPack(const Diagnostics& diagnostics);

/// The diagnostic with its effect, which the message states: "...; Iris ignores this line".
Diagnostic withEffect(Diagnostic diagnostic, Effect effect);

/// "file:line:column", as much of it as is known; printable().
std::string formatLocation(const SourceLocation& at);

/// "file:line:column: error: message", then include chain, source line with caret, places, notes, hint;
/// lines joined by '\n', no trailing newline. Each of these texts is printable().
std::string formatDiagnostic(const Diagnostic& diagnostic);

/// Removes exact repetitions (same severity, place and message), keeping the first of each.
void removeDuplicates(Diagnostics& diagnostics);

}  // namespace orris
