// The line format of *.properties files. Contract: properties.csv "(file)", idmaps.csv common.*.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

/// One key and its value; escapes resolved, continued lines joined.
struct PropertyEntry {
  std::string key;
  std::string value;
  SourceLocation at;  ///< of the key
  /// As written, from the line of the key on; "" for a line that preprocessing took away.
  std::vector<std::string> lines;
};

/// One word of an entry's value, and where the author wrote it.
struct PropertyWord {
  std::string text;
  SourceLocation at;
  std::string_view sourceLine;  ///< of the entry, which must outlive it: a line may have many words
  bool written = false;         ///< some line holds it as it is; else it is placed at the key
};

/// How an entry goes on after a line that ends in a backslash.
enum class Continuation {
  Java,          ///< with the next line, whatever it is
  Preprocessed,  ///< blanks may follow the backslash; lines that the author left blank are skipped,
                 ///< directives, comments and inactive lines end the entry
};

/// All entries in order of appearance, duplicates included. `original` is the text before
/// preprocessing, line by line the same; it defaults to `text`.
std::vector<PropertyEntry> parseProperties(const std::string& file, std::string_view text,
                                           Continuation continuation,
                                           std::string_view original = {});

/// Of each key the last value, at the place in the order where the key first appeared.
std::vector<PropertyEntry> lastValues(const std::vector<PropertyEntry>& entries);

/// The words of the value between blanks. A word that no line holds as it is, because a macro or an
/// escape made it, is placed at the key.
std::vector<PropertyWord> locatedWords(const PropertyEntry& entry);

/// The name, number or sign at `offset` of the value, and where the author wrote it; as above where
/// no line holds it.
PropertyWord locatedToken(const PropertyEntry& entry, std::size_t offset);

/// A diagnostic at `word`, without the line for the caret where that is too long to be of use.
Diagnostic wordDiagnostic(Severity severity, std::string id, const PropertyWord& word,
                          std::string message, std::string hint = {});

/// A diagnostic at `word` where the author's lines hold it, else at the entry's key.
Diagnostic propertyDiagnostic(Severity severity, std::string id, const PropertyEntry& entry,
                              std::string message, std::string hint = {},
                              std::string_view word = {});

}  // namespace orris
