// Option files beside a pack: "NAME=value" lines. Contract: options.csv file.format.
#include <fmt/format.h>

#include <orris/pack/files/properties_text.h>
#include <orris/pack/files/text.h>
#include <orris/pack/options/options.h>

namespace orris {
namespace {

std::vector<std::string> namesOf(const OptionSet& options) {
  std::vector<std::string> names;
  for (const auto& entry : options.all()) names.push_back(entry.first);
  return names;
}

}  // namespace

OptionValues parseOptionFile(const std::string& file, const std::string& text,
                             const OptionSet& options, Diagnostics& diagnostics) {
  OptionValues values;
  for (const PropertyEntry& entry : lastValues(parseProperties(file, text, Continuation::Java))) {
    const std::string value(trim(entry.value));
    const Option* option = options.find(entry.key);
    if (!option) {
      diagnostics.push_back(propertyDiagnostic(Severity::Warning, "option-unknown", entry,
                                               fmt::format("the pack has no option {}", entry.key),
                                               suggest(entry.key, namesOf(options))));
    } else if (option->isBoolean && value != "true" && value != "false") {
      diagnostics.push_back(
          propertyDiagnostic(Severity::Warning, "option-value", entry,
                             fmt::format("{} is \"{}\", expected true or false; it keeps {}",
                                         entry.key, value, option->defaultValue)));
    } else {
      values[entry.key] = value;
    }
  }
  return values;
}

std::string writeOptionFile(const OptionSet& options, const OptionValues& values) {
  std::string text;
  for (const auto& [name, value] : values) {
    const Option* option = options.find(name);
    if (option && option->defaultValue != value) text += fmt::format("{}={}\n", name, value);
  }
  return text;
}

}  // namespace orris
