#include <orris/glsl/rewrite/interface_repair.h>

#include <algorithm>
#include <array>
#include <string_view>

#include <orris/core/characters.h>
#include <orris/glsl/tokens/file_scope.h>
#include <orris/glsl/tokens/outline.h>
#include <orris/glsl/tokens/text_edits.h>
#include <orris/glsl/tokens/text_tokens.h>

namespace orris {
namespace {

/// Components of a scalar or vector type that can be a varying; 0 for any other.
int componentsOf(std::string_view type) {
  constexpr std::array<std::string_view, 3> kScalars = {"float", "int", "uint"};
  if (std::find(kScalars.begin(), kScalars.end(), type) != kScalars.end()) return 1;
  if (type.starts_with('i') || type.starts_with('u')) type.remove_prefix(1);
  if (type.size() != 4 || !type.starts_with("vec")) return 0;
  return type[3] >= '2' && type[3] <= '4' ? type[3] - '0' : 0;
}

bool isMatrix(std::string_view type) { return type.starts_with("mat"); }

/// Offsets of a name; members of structs with the same name are left out.
std::vector<std::size_t> placesOf(std::string_view text, std::string_view name) {
  std::vector<std::size_t> places;
  for (std::size_t at = text.find(name); at != std::string_view::npos;
       at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool whole = (at == 0 || !isWordCharacter(text[at - 1])) &&
                       (end == text.size() || !isWordCharacter(text[end]));
    if (whole && !(at > 0 && text[at - 1] == '.')) places.push_back(at);
  }
  return places;
}

/// Does the name stand for something else there: in a declaration, or as that of a function?
bool standsAtFileScope(const StageText& stage, std::string_view name) {
  const std::vector<Token> tokens = tokensOf(stage.text);
  const std::vector<OutlineItem> items = outline(tokens);
  return std::any_of(items.begin(), items.end(), [&](const OutlineItem& item) {
    const bool function = item.kind == OutlineItem::Kind::Function;
    const std::size_t begin = function ? item.name : item.begin;
    const std::size_t end = function ? item.name + 1 : item.end;
    return std::any_of(tokens.begin() + static_cast<std::ptrdiff_t>(begin),
                       tokens.begin() + static_cast<std::ptrdiff_t>(end),
                       [name](const Token& token) { return isIdentifier(token, name); });
  });
}

/// One stage while it is repaired; edits keep the offsets of the text as it was.
struct RepairedStage {
  const StageText* stage = nullptr;
  FileScope scope;
  TextEdits edits;

  std::string_view text() const { return stage->text.text; }
  const StageVarying* output(std::string_view name) const {
    const auto found =
        std::find_if(scope.varyings.begin(), scope.varyings.end(),
                     [&](const StageVarying& v) { return !v.input && v.name == name; });
    return found == scope.varyings.end() ? nullptr : &*found;
  }
};

class Repair {
 public:
  explicit Repair(const std::vector<const StageText*>& stages) {
    for (const StageText* stage : stages)
      stages_.push_back({stage, readFileScope(stage->text.text), {}});
  }

  std::optional<RepairedInterface> run() {
    for (std::size_t i = 1; i < stages_.size(); ++i) repairPair(stages_[i - 1], stages_[i]);
    if (result_.names.empty()) return std::nullopt;
    for (RepairedStage& stage : stages_)
      result_.stages.push_back({stage.stage->stage, stage.edits.apply(stage.stage->text)});
    return std::move(result_);
  }

 private:
  void repairPair(RepairedStage& from, RepairedStage& to) {
    if (from.scope.mainBegin == std::string::npos) return;
    for (const StageVarying& in : to.scope.varyings) {
      if (!in.input || in.name.starts_with("gl_") || in.layout) continue;
      const bool known = componentsOf(in.type) > 0 || isMatrix(in.type);
      // Stages that see one element for each vertex declare arrays of what comes before.
      const bool perVertex = to.stage->stage != Stage::Fragment;
      if (!known || (in.array && !perVertex)) continue;
      const StageVarying* out = from.output(in.name);
      if (out == nullptr) {
        declare(from, to, in);
      } else if (!out->array && !out->layout) {
        out->type == in.type ? initialise(from, *out) : convert(from, *out, in);
      }
    }
  }

  void declare(RepairedStage& from, const RepairedStage& to, const StageVarying& in) {
    if (placesOf(to.text(), in.name).size() < 2) return;
    if (!placesOf(from.text(), in.name).empty() && standsAtFileScope(*from.stage, in.name)) return;
    from.edits.insert(from.scope.first, in.qualifiers + "out " + in.type + " " + in.name + "; ");
    from.edits.insert(from.scope.mainBegin, " " + in.name + " = " + in.type + "(0);");
    result_.names.push_back(in.name);
  }

  void initialise(RepairedStage& from, const StageVarying& out) {
    if (placesOf(from.text(), out.name).size() != 1) return;
    from.edits.insert(from.scope.mainBegin, " " + out.name + " = " + out.type + "(0);");
    result_.names.push_back(out.name);
  }

  void convert(RepairedStage& from, const StageVarying& out, const StageVarying& in) {
    const int have = componentsOf(out.type), want = componentsOf(in.type);
    const bool vectors = have > 0 && want > 0 && (have == 1) == (want == 1);
    if (!vectors && !(isMatrix(out.type) && isMatrix(in.type))) return;
    const std::string own = "orris_" + out.name;
    for (const std::size_t at : placesOf(from.text(), out.name))
      from.edits.rename(at, out.name.size(), own);
    from.edits.insert(from.scope.first, out.qualifiers + "out " + in.type + " " + out.name + "; ");
    const std::string value = have < want ? own + ", vec4(0)" : own;
    from.edits.insert(from.scope.mainEnd, " " + out.name + " = " + in.type + "(" + value + "); ");
    result_.names.push_back(out.name);
  }

  std::vector<RepairedStage> stages_;
  RepairedInterface result_;
};

}  // namespace

std::optional<RepairedInterface> repairInterface(const std::vector<const StageText*>& stages) {
  if (stages.size() < 2) return std::nullopt;
  return Repair(stages).run();
}

}  // namespace orris
