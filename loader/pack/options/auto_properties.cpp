#include <orris/pack/options/auto_properties.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <orris/pack/files/properties_text.h>
#include <orris/pack/files/text.h>
#include <orris/pack/versions/features.h>

namespace orris {
namespace {

constexpr std::string_view kAutoPrefix = "auto.";

/// The entry of `names` that is `word` but for case: macros of the same name as an option would
/// take its place in the file, so it is written in lower case.
std::string spelled(std::string_view word, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (lowerCase(name) == lowerCase(word)) return name;
  return "";
}

std::vector<std::string> autoOptions(const OptionSet& options) {
  std::vector<std::string> names;
  for (const auto& [name, option] : options.all())
    if (std::find(option.values.begin(), option.values.end(), kAutoValue) != option.values.end())
      names.push_back(name);
  return names;
}

struct EntryContext {
  const PropertyEntry& entry;
  Diagnostics& diagnostics;

  void fail(std::string message, std::string hint, std::string_view word = {}) const {
    diagnostics.push_back(propertyDiagnostic(Severity::Warning, "auto-option", entry,
                                             std::move(message), std::move(hint), word));
  }
};

/// Words of a cost, one after the other.
class CostReader {
 public:
  CostReader(const EntryContext& context, AutoCandidate& out)
      : context_(context), out_(out), words_(splitBlanks(context.entry.value)) {}

  /// false: reported.
  bool read() {
    do {
      if (!readTerm()) return false;
    } while (take("+"));
    if (take("if")) do {
        if (!readCondition()) return false;
      } while (take("and"));
    return next_ == words_.size() || fail("expected +, if or the end");
  }

 private:
  std::string_view word() const {
    return next_ < words_.size() ? std::string_view(words_[next_]) : std::string_view();
  }

  bool take(std::string_view expected) {
    if (word() != expected) return false;
    ++next_;
    return true;
  }

  bool fail(std::string what) const {
    context_.fail(fmt::format("{}: {}{}", context_.entry.key, what,
                              word().empty() ? "" : fmt::format(", not \"{}\"", word())),
                  "costs read like 0.3 + 2e-6 pixels lamps if lamps < 100", word());
    return false;
  }

  std::optional<double> number() {
    const auto value = parseFloat(word());
    if (!value || !std::isfinite(*value)) return std::nullopt;
    ++next_;
    return *value;
  }

  bool quantity(std::string& name) {
    const auto known = sceneQuantities();
    const bool found = std::any_of(known.begin(), known.end(),
                                   [&](const SceneQuantity& q) { return q.name == word(); });
    if (!found) {
      std::vector<std::string> names;
      for (const SceneQuantity& q : known) names.emplace_back(q.name);
      return fail("expected one of " + joinNames(names));
    }
    name = words_[next_++];
    return true;
  }

  /// Numbers first: `1e-6 2048 2048 lamps`, as an option's value may be one of them.
  bool readTerm() {
    const auto first = number();
    if (!first) return fail("expected a number");
    CostTerm& term = out_.terms.emplace_back(CostTerm{*first, {}});
    while (const auto next = number()) term.factor *= *next;
    while (!word().empty() && word() != "+" && word() != "if")
      if (!quantity(term.quantities.emplace_back())) return false;
    return true;
  }

  bool readCondition() {
    CostCondition& condition = out_.conditions.emplace_back();
    if (!quantity(condition.quantity)) return false;
    condition.below = word() == "<";
    if (!take("<") && !take(">=")) return fail("expected < or >=");
    const auto bound = number();
    if (!bound) return fail("expected a number");
    condition.bound = *bound;
    return true;
  }

  const EntryContext& context_;
  AutoCandidate& out_;
  std::vector<std::string> words_;
  std::size_t next_ = 0;
};

/// Which value of which option the key names; false: reported.
bool readName(const EntryContext& context, const OptionSet& all, AutoCandidate& out) {
  const std::string_view rest = std::string_view(context.entry.key).substr(kAutoPrefix.size());
  const std::size_t dot = std::min(rest.find('.'), rest.size());
  const std::vector<std::string> options = autoOptions(all);
  out.option = spelled(rest.substr(0, dot), options);
  if (out.option.empty()) {
    context.fail(fmt::format("{}: no such option has the value {}", context.entry.key, kAutoValue),
                 suggest(upperCase(rest.substr(0, dot)), options));
    return false;
  }
  const std::vector<std::string>& values = all.find(out.option)->values;
  out.value = dot < rest.size() ? spelled(rest.substr(dot + 1), values) : "";
  if (!out.value.empty() && out.value != kAutoValue) return true;
  context.fail(fmt::format("{}: {} has no other value of that name", context.entry.key, out.option),
               "its values are " + joinNames(values));
  return false;
}

}  // namespace

bool asksForAuto(const ShaderProperties& properties) {
  for (const auto* flags : {&properties.orrisRequiredFeatures, &properties.orrisOptionalFeatures})
    if (std::find(flags->begin(), flags->end(), kAutoOptions) != flags->end()) return true;
  return false;
}

std::vector<AutoCandidate> parseAutoOptions(const std::string& file, const std::string& text,
                                            const MacroDefinitions& macros,
                                            const OptionSet& options, Diagnostics& diagnostics) {
  Diagnostics reported;  // by whoever read the file for its other keys
  const std::string active = preprocessProperties(file, text, macros, reported);
  std::vector<AutoCandidate> candidates;
  for (const PropertyEntry& entry :
       lastValues(parseProperties(file, active, Continuation::Preprocessed, text))) {
    if (!entry.key.starts_with(kAutoPrefix)) continue;
    const EntryContext context{entry, diagnostics};
    AutoCandidate candidate;
    candidate.at = entry.at;
    if (readName(context, options, candidate) && CostReader(context, candidate).read())
      candidates.push_back(std::move(candidate));
  }
  return candidates;
}

}  // namespace orris
