#include <orris/check/matrix/minimise.h>

#include <fmt/format.h>

#include <algorithm>

namespace orris {
namespace {

using Setting = std::pair<const std::string, std::string>;

OptionValues asValues(const std::vector<Setting>& settings, std::size_t skipFrom,
                      std::size_t skipTo) {
  OptionValues values;
  for (std::size_t i = 0; i < settings.size(); ++i) {
    if (i < skipFrom || i >= skipTo) values.insert(settings[i]);
  }
  return values;
}

// One option changed alone: with which values it fails. Nothing tried: no values.
Condition tryValues(const Option& option, const OptionValues& minimal, const std::string& current,
                    const FailsWith& fails, int& tries) {
  Condition condition{.option = option.name};
  for (const std::string& value : option.values) {
    Trial trial = Trial::Fails;
    if (value != current) {
      if (tries <= 0) continue;
      --tries;
      OptionValues values = minimal;
      values.erase(option.name);
      if (value != option.defaultValue) values[option.name] = value;
      trial = fails(values);
    }
    if (trial == Trial::Fails) condition.values.push_back(value);
    if (trial == Trial::Good) condition.others.push_back(value);
  }
  return condition;
}

// Most options do not matter; two other values tell that well enough.
bool mayMatter(const Option& option, const OptionValues& minimal, const std::string& current,
               const FailsWith& fails, int& tries) {
  int left = 2;
  for (auto value = option.values.rbegin(); value != option.values.rend() && left > 0; ++value) {
    if (*value == current) continue;
    if (tries <= 0) return false;
    --left;
    --tries;
    OptionValues values = minimal;
    values.erase(option.name);
    if (*value != option.defaultValue) values[option.name] = *value;
    if (fails(values) == Trial::Good) return true;
  }
  return false;
}

}  // namespace

OptionValues minimalValues(const OptionValues& values, const FailsWith& fails, int& tries) {
  std::vector<Setting> settings(values.begin(), values.end());
  std::size_t parts = 2;
  while (!settings.empty() && tries > 0) {
    const std::size_t size = (settings.size() + parts - 1) / parts;
    bool smaller = false;
    for (std::size_t from = 0; from < settings.size() && tries > 0; from += size) {
      --tries;
      const OptionValues rest = asValues(settings, from, from + size);
      if (fails(rest) != Trial::Fails) continue;
      std::vector<Setting>(rest.begin(), rest.end()).swap(settings);
      parts = std::max<std::size_t>(parts - 1, 2);
      smaller = true;
      break;
    }
    if (smaller) continue;
    if (size <= 1) break;
    parts = std::min(parts * 2, settings.size());
  }
  return {settings.begin(), settings.end()};
}

Cause findCause(const OptionSet& options, const OptionValues& minimal,
                const std::vector<std::string>& others, const FailsWith& fails, int tries) {
  Cause cause;
  for (const auto& [name, value] : minimal) {
    if (const Option* option = options.find(name)) {
      cause.conditions.push_back(tryValues(*option, minimal, value, fails, tries));
    }
  }
  for (const std::string& name : others) {
    const Option* option = options.find(name);
    if (!option || minimal.contains(name)) continue;
    if (mayMatter(*option, minimal, option->defaultValue, fails, tries)) {
      cause.conditions.push_back(tryValues(*option, minimal, option->defaultValue, fails, tries));
    }
  }
  cause.complete = tries > 0;
  return cause;
}

std::string describe(const Cause& cause, const OptionSet& options) {
  std::string text;
  for (const Condition& condition : cause.conditions) {
    const Option* option = options.find(condition.option);
    if (!text.empty()) text += " and ";
    if (condition.values.size() == 1) {
      text += fmt::format("{}={}", condition.option, condition.values.front());
    } else if (condition.others.size() == 1 && option &&
               condition.values.size() + 1 == option->values.size()) {
      text += fmt::format("{} is not {}", condition.option, condition.others.front());
    } else {
      text += fmt::format("{} is {}", condition.option, fmt::join(condition.values, " or "));
    }
  }
  return text;
}

}  // namespace orris
