#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include <orris/pack/expressions/expression.h>
#include <orris/pack/expressions/expression_program.h>
#include <orris/pack/files/properties_text.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

/// Collects the names of variables; a tree has at most 2048 nodes.
void collectNames(const ExpressionTree& tree, std::set<std::string>& names) {
  if (tree.kind == ExpressionTree::Kind::Name) names.insert(tree.name);
  for (const ExpressionTree& argument : tree.arguments) collectNames(argument, names);
}

struct Parsed {
  const CustomUniform* entry = nullptr;
  std::optional<ExpressionTree> tree;
  std::set<std::string> names;
};

}  // namespace

Value Value::ofInt(int v) {
  Value value{.type = ValueType::Int};
  value.i[0] = v;
  return value;
}

Value Value::ofBool(bool v) {
  Value value{.type = ValueType::Bool};
  value.i[0] = v ? 1 : 0;
  return value;
}

Value Value::ofFloat(float v) {
  Value value{.type = ValueType::Float};
  value.f[0] = v;
  return value;
}

struct CustomUniforms::Impl {
  struct Entry {
    ExpressionNode node;
    bool uploaded = true;
  };
  std::vector<Entry> entries;  ///< in evaluation order
  std::vector<Value> current;
  std::vector<SmoothState> smooth;
  std::vector<std::pair<std::string, Value>> values;
  int smoothStates = 0;
};

namespace {

/// Orders the entries by dependency and compiles them one by one.
class Builder {
 public:
  Builder(const std::vector<CustomUniform>& entries, const InputTypes& inputs,
          Diagnostics& diagnostics)
      : inputs_(inputs), diagnostics_(diagnostics) {
    for (const CustomUniform& entry : entries) parse(entry);
  }

  /// `add` gets each entry that compiles, after all that it depends on.
  template <typename Add>
  void compileAll(int& smoothStates, Add add) {
    for (const std::string& name : order()) {
      const Parsed& parsed = parsed_.at(name);
      ExpressionFindings findings;
      const auto lookup = [this](const std::string& used) { return find(used); };
      auto node =
          compileExpression(*parsed.tree, parsed.entry->type, lookup, smoothStates, findings);
      if (!node) {
        drop(*parsed.entry, findings.error);
        continue;
      }
      for (const ExpressionError& slip : findings.slips) reportSlip(*parsed.entry, slip);
      const int index = static_cast<int>(compiled_.size());
      compiled_.emplace(name, ExpressionVariable{parsed.entry->type, index});
      add(*parsed.entry, std::move(*node));
    }
  }

 private:
  void parse(const CustomUniform& entry) {
    if (parsed_.contains(entry.name)) return;
    if (inputs_(entry.name)) {
      return drop(entry, {fmt::format("{} is a uniform of the host", entry.name), 0});
    }
    Parsed parsed{.entry = &entry};
    ExpressionError error;
    parsed.tree = parseExpression(entry.expression, error);
    if (!parsed.tree) return drop(entry, error);
    collectNames(*parsed.tree, parsed.names);
    names_.push_back(entry.name);
    parsed_.insert_or_assign(entry.name, std::move(parsed));
  }

  std::optional<ExpressionVariable> find(const std::string& name) const {
    const auto compiled = compiled_.find(name);
    if (compiled != compiled_.end()) return compiled->second;
    const auto type = inputs_(name);
    return type ? std::optional(ExpressionVariable{*type, -1}) : std::nullopt;
  }

  /// `column` is of the expression; 0 stands for the key.
  Diagnostic at(const CustomUniform& entry, int column, std::string id, std::string message) {
    const PropertyEntry written{entry.name, entry.expression, entry.at, entry.lines};
    Diagnostic diagnostic{.severity = Severity::Warning,
                          .id = std::move(id),
                          .at = entry.at,
                          .message = std::move(message),
                          .sourceLine = entry.lines.front()};
    if (column > 0) {
      const PropertyWord word = locatedToken(written, static_cast<size_t>(column) - 1);
      diagnostic.at = word.at;
      diagnostic.sourceLine = word.sourceLine;
    }
    return diagnostic;
  }

  void drop(const CustomUniform& entry, const ExpressionError& error) {
    dropped_.insert(entry.name);
    Diagnostic diagnostic =
        at(entry, error.column, "uniform-dropped",
           fmt::format("custom uniform {} is dropped: {}", entry.name, describe(error.message)));
    // A pack names the biomes of newer games than the one it runs in.
    if (error.message.starts_with("unknown name BIOME_")) diagnostic.severity = Severity::Note;
    diagnostic.effect = Effect::IgnoresLine;
    diagnostics_.push_back(std::move(diagnostic));
  }

  void reportSlip(const CustomUniform& entry, const ExpressionError& slip) {
    Diagnostic diagnostic = at(entry, slip.column, "expression-slip", slip.message);
    diagnostic.hint = "a slip of Iris's: nest calls of two, max(a, max(b, c))";
    diagnostics_.push_back(std::move(diagnostic));
  }

  /// An unknown name that was itself dropped deserves a better word.
  std::string describe(const std::string& message) const {
    constexpr std::string_view kUnknown = "unknown name ";
    if (!message.starts_with(kUnknown)) return message;
    const std::string name = message.substr(kUnknown.size());
    return dropped_.contains(name) ? fmt::format("it uses {}, which is dropped", name) : message;
  }

  /// Names in an order in which each stands after those it uses; members of cycles are left out.
  std::vector<std::string> order() {
    std::map<std::string, int> waiting;
    std::map<std::string, std::vector<std::string>> users;
    for (const std::string& name : names_) {
      int& count = waiting[name];
      for (const std::string& used : parsed_.at(name).names) {
        if (!parsed_.contains(used)) continue;
        ++count;
        users[used].push_back(name);
      }
    }
    std::vector<std::string> sorted;
    for (const std::string& name : names_) {
      if (waiting[name] == 0) sorted.push_back(name);
    }
    for (size_t i = 0; i < sorted.size(); ++i) {
      const std::string used = sorted[i];
      for (const std::string& user : users[used]) {
        if (--waiting[user] == 0) sorted.push_back(user);
      }
    }
    reportCycles(waiting);
    return sorted;
  }

  void reportCycles(const std::map<std::string, int>& waiting) {
    std::vector<std::string> cyclic;
    for (const std::string& name : names_) {
      if (waiting.at(name) > 0) cyclic.push_back(name);
    }
    if (cyclic.empty()) return;
    const CustomUniform& first = *parsed_.at(cyclic.front()).entry;
    diagnostics_.push_back(withEffect(
        {.severity = Severity::Error,
         .id = "uniform-cycle",
         .at = first.at,
         .message = "custom uniforms depend on each other in a circle: " + joinNames(cyclic),
         .sourceLine = first.lines.front()},
        Effect::RefusesPack));
  }

  const InputTypes& inputs_;
  Diagnostics& diagnostics_;
  std::vector<std::string> names_;
  std::map<std::string, Parsed> parsed_;
  std::map<std::string, ExpressionVariable> compiled_;
  std::set<std::string> dropped_;
};

}  // namespace

CustomUniforms::CustomUniforms(const std::vector<CustomUniform>& entries, const InputTypes& inputs,
                               Diagnostics& diagnostics)
    : impl_(std::make_unique<Impl>()) {
  Builder(entries, inputs, diagnostics)
      .compileAll(impl_->smoothStates, [this](const CustomUniform& entry, ExpressionNode node) {
        Value zero;
        zero.type = entry.type;
        impl_->entries.push_back({std::move(node), entry.uploaded});
        impl_->current.push_back(zero);
        if (entry.uploaded) impl_->values.emplace_back(entry.name, zero);
      });
  impl_->smooth.resize(static_cast<size_t>(impl_->smoothStates));
}

CustomUniforms::~CustomUniforms() = default;
CustomUniforms::CustomUniforms(CustomUniforms&&) noexcept = default;
CustomUniforms& CustomUniforms::operator=(CustomUniforms&&) noexcept = default;

void CustomUniforms::evaluate(const InputValues& inputs, float frameTime, unsigned seed) {
  EvaluationState state{inputs, impl_->current, impl_->smooth, {frameTime, seed}};
  size_t uploaded = 0;
  for (size_t i = 0; i < impl_->entries.size(); ++i) {
    impl_->current[i] = evaluateExpression(impl_->entries[i].node, state);
    if (impl_->entries[i].uploaded) impl_->values[uploaded++].second = impl_->current[i];
  }
}

const std::vector<std::pair<std::string, Value>>& CustomUniforms::values() const {
  return impl_->values;
}

}  // namespace orris
