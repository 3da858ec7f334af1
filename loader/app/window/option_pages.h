// A pack's options screens as the game shows them: pages of cells, without a window.
// Contract: options.csv screen.items, screen.default, lang.keys.
#pragma once

#include <string>
#include <vector>

#include <orris/pack/shader_pack.h>

namespace orris {

struct OptionCell {
  enum class Kind {
    Empty,
    Boolean,
    Choice,
    Slider,
    Profile,
    Screen,
    Missing,  ///< a word on the screen that is no option
  };
  Kind kind = Kind::Empty;
  std::string name;            ///< of the option or screen; "" for others
  std::string label;           ///< with colour codes; the name where the language file has none
  bool labelMissing = false;   ///< the language file has no text for it
  std::string value;           ///< in force
  std::string valueLabel;      ///< with colour codes
  std::string comment;         ///< tooltip, "" for none
  std::vector<std::string> values;
  bool changed = false;        ///< an option that is not its default, or a screen that leads to one
};

struct OptionPage {
  std::string name;   ///< "" for the main screen
  std::string title;  ///< with colour codes
  int columns = 2;
  std::vector<OptionCell> cells;
};

/// What stands on a screen; the main one where there is none of that name.
OptionPage optionPage(const ShaderPack& pack, const std::string& screen);

/// The options with all words of `text` in name, label, comment or values, by name.
OptionPage searchOptions(const ShaderPack& pack, const std::string& text);

/// How a value is shown: value.*, else with prefix.* and suffix.*; ON and OFF for booleans.
std::string valueLabelOf(const ShaderPack& pack, const Option& option, const std::string& value);

/// The value `steps` further in the option's list, round and round.
std::string valueBeside(const Option& option, const std::string& value, int steps);

}  // namespace orris
