// Small readers for the line-based texts of a pack.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orris/core/characters.h>

namespace orris {

/// Without blanks, tabs, carriage returns and other control characters at both ends.
std::string_view trim(std::string_view text);
/// Words between runs of blanks.
std::vector<std::string> splitBlanks(std::string_view text);
/// Words between single blanks: of two blanks side by side an empty word is left, but for those at
/// the end. Java: String.split(" "), by which Iris reads most values.
std::vector<std::string> splitSingleBlanks(std::string_view text);
/// Parts between `separator`, empty ones kept.
std::vector<std::string_view> splitAt(std::string_view text, char separator);
/// Lines without their ends (LF, CRLF or CR); a NUL byte is dropped.
std::vector<std::string> splitLines(std::string_view text);

/// Letters, digits and '_' at the start of `text`.
std::string_view leadingWord(std::string_view text);

/// Whole text as a number; a float may end in f. nullopt when it is none or out of range.
std::optional<long long> parseInteger(std::string_view text);
std::optional<float> parseFloat(std::string_view text);
/// "true" or "1", "false" or "0", else nullopt. Contract: properties.csv "(boolean values)".
std::optional<bool> parseBoolean(std::string_view text);

/// With the namespace of the game where `name` has none.
std::string withNamespace(std::string_view name);

std::string joinNames(const std::vector<std::string>& names);
std::string lowerCase(std::string_view text);
std::string upperCase(std::string_view text);

/// Least number of slips: characters inserted, removed, replaced, and neighbours exchanged.
size_t editDistance(std::string_view a, std::string_view b);
/// The name with the fewest edits from `name`, "" when none is within a third of its length. None
/// that differs in a whole word, as rainStrength does from windStrength, or in its number.
std::string nearestName(std::string_view name, const std::vector<std::string>& names);
/// "did you mean X?" or "".
std::string suggest(std::string_view name, const std::vector<std::string>& names);

}  // namespace orris
