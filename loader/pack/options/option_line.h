// One line of shader text as an option definition. Contract: options.csv scan.line to const.other.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// What a line defines. Boolean: value is "true" or "false", values {"true","false"}.
struct OptionLine {
  std::string name;
  bool isBoolean = false;
  bool isConst = false;
  std::string value;
  std::vector<std::string> values;
  std::string comment;
};

/// nullopt when the line is no option definition (or a const whose name is not configurable).
std::optional<OptionLine> parseOptionLine(std::string_view line);

/// The name that a line defines with #define, be it commented out, an option or neither; else "".
std::string_view definedName(std::string_view line);

/// The name on a line that is exactly #ifdef NAME or #ifndef NAME, else "".
std::string_view booleanReference(std::string_view line);

/// The name after #ifdef or #ifndef, whatever follows it, else "".
std::string_view askedName(std::string_view line);

/// The line with `value` in place of the one it defines. `option` is what parseOptionLine() said.
std::string editOptionLine(const std::string& line, const OptionLine& option,
                           const std::string& value);

}  // namespace orris
