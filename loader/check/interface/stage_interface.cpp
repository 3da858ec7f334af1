#include <orris/check/interface/stage_interface.h>

#include <algorithm>
#include <unordered_map>

#include <orris/check/compile/text_scanner.h>
#include <orris/check/interface/stage_uses.h>
#include <orris/glsl/preprocess/condition.h>
#include <orris/glsl/tokens/outline.h>

namespace orris {
namespace {

using Statement = std::vector<TextToken>;
using Storage = StageGlobal::Storage;

class StageReader {
 public:
  explicit StageReader(const StageText& stage) : scanner_(stage.text.text) { out_.stage = &stage; }

  StageInterface run() {
    while (readStatement()) {
    }
    uses_.markReached(out_);
    return std::move(out_);
  }

 private:
  bool readStatement() {
    statement_.clear();
    int depth = 0;
    bool assigned = false;
    for (TextToken token = scanner_.next(); token.kind != TextToken::Kind::End;
         token = scanner_.next()) {
      if (token.is('{') && depth == 0 && !assigned && !statement_.empty() &&
          statement_.back().is(')')) {
        readFunction();
        return true;
      }
      depth += token.is('(') || token.is('[') || token.is('{');
      depth -= token.is(')') || token.is(']') || token.is('}');
      assigned |= token.is('=') && depth == 0;
      statement_.push_back(token);
      if (depth <= 0 && token.is(';')) {
        readDeclaration();
        return true;
      }
    }
    return false;
  }

  // ---- declarations

  const TextToken& at(std::size_t i) const {
    static const TextToken kEnd;
    return i < statement_.size() ? statement_[i] : kEnd;
  }

  std::size_t closing(std::size_t open) const {
    int depth = 0;
    for (std::size_t i = open; i < statement_.size(); ++i) {
      const TextToken& t = statement_[i];
      depth += t.is('(') || t.is('[') || t.is('{');
      depth -= t.is(')') || t.is(']') || t.is('}');
      if (depth == 0) return i;
    }
    return statement_.size();
  }

  void readDeclaration() {
    StageGlobal global;
    std::size_t i = readQualifiers(0, global);
    if (at(i).text == "precision" || !at(i).isWord()) return;
    if (at(i).text == "struct") return readStruct(i + 1, global);
    global.type = at(i).text;
    global.place = {at(i).line, at(i).column};
    ++i;
    if (at(i).is('{')) return readBlock(i, std::move(global));
    std::vector<std::int64_t> sizes;
    i = readSizes(i, sizes);
    if (at(i).isWord() && at(i + 1).is('(')) return uses_.addFunction(at(i).text);
    readDeclarators(i, global, sizes);
  }

  std::size_t readQualifiers(std::size_t i, StageGlobal& global) {
    while (at(i).isWord() && isQualifier(at(i).text)) {
      const std::string_view word = at(i).text;
      ++i;
      if (word == "layout") {
        readLayout(i, global);
        i = closing(i) + 1;
      } else if (word == "subroutine" && at(i).is('(')) {
        i = closing(i) + 1;
      } else {
        takeQualifier(word, global);
      }
    }
    return i;
  }

  static void takeQualifier(std::string_view word, StageGlobal& global) {
    if (word == "in" || word == "attribute") global.storage = Storage::In;
    if (word == "out") global.storage = Storage::Out;
    if (word == "uniform") global.storage = Storage::Uniform;
    if (word == "buffer") global.storage = Storage::Buffer;
    if (word == "shared") global.storage = Storage::Shared;
    if (word == "flat") global.interpolation = StageGlobal::Interpolation::Flat;
    if (word == "noperspective") global.interpolation = StageGlobal::Interpolation::NoPerspective;
    global.patch |= word == "patch";
    global.constant |= word == "const";
  }

  void readLayout(std::size_t open, StageGlobal& global) {
    struct LayoutRow {
      std::string_view word;
      int LayoutNumbers::*field;
    };
    static constexpr LayoutRow kRows[] = {{"location", &LayoutNumbers::location},
                                          {"index", &LayoutNumbers::index},
                                          {"binding", &LayoutNumbers::binding},
                                          {"component", &LayoutNumbers::component}};
    const std::size_t close = closing(open);
    for (std::size_t i = open + 1; i < close; ++i) {
      if (!at(i).isWord()) continue;
      const auto row = std::find_if(std::begin(kRows), std::end(kRows),
                                    [&](const LayoutRow& r) { return r.word == at(i).text; });
      if (row == std::end(kRows)) {
        if (!at(i + 1).is('=')) global.format = at(i).text;
        continue;
      }
      if (!at(i + 1).is('=')) continue;
      std::size_t end = i + 2;
      while (end < close && !at(end).is(',')) ++end;
      global.layout.*row->field = static_cast<int>(evaluate(i + 2, end));
      i = end;
    }
  }

  /// The constant expression of the tokens [begin, end), -1 when it is not known.
  std::int64_t evaluate(std::size_t begin, std::size_t end) const {
    std::vector<Token> tokens;
    for (std::size_t i = begin; i < end; ++i) {
      std::string text(at(i).text);
      if (at(i).isWord()) {
        const auto known = constants_.find(at(i).text);
        if (known == constants_.end()) return -1;
        text = std::to_string(known->second);
      } else if (at(i).kind == TextToken::Kind::Number &&
                 (text.back() == 'u' || text.back() == 'U')) {
        text.pop_back();
      }
      const bool number = at(i).kind != TextToken::Kind::Punctuator;
      Token& token = tokens.emplace_back();
      token.kind = number ? TokenKind::Number : TokenKind::Punctuator;
      token.text = std::move(text);
    }
    const ConditionResult result = evaluateCondition(tokens);
    return result.problem.empty() && result.used == tokens.size() && result.value >= 0
               ? result.value
               : -1;
  }

  std::size_t readSizes(std::size_t i, std::vector<std::int64_t>& sizes) const {
    while (at(i).is('[')) {
      const std::size_t close = closing(i);
      sizes.push_back(close == i + 1 ? 0 : evaluate(i + 1, close));
      i = close + 1;
    }
    return i;
  }

  void readDeclarators(std::size_t i, const StageGlobal& base,
                       const std::vector<std::int64_t>& typeSizes) {
    while (at(i).isWord()) {
      StageGlobal global = base;
      global.name = at(i).text;
      global.place = {at(i).line, at(i).column};
      i = readSizes(i + 1, global.arraySizes);
      global.arraySizes.insert(global.arraySizes.end(), typeSizes.begin(), typeSizes.end());
      global.initialised = at(i).is('=');
      FunctionUses initialiser;
      if (global.initialised) i = readInitialiser(i + 1, global, initialiser);
      addGlobal(std::move(global));
      uses_.setInitialiser(std::move(initialiser));
      if (!at(i).is(',')) break;
      ++i;
    }
  }

  std::size_t readInitialiser(std::size_t i, const StageGlobal& global, FunctionUses& uses) {
    const std::size_t begin = i;
    for (int depth = 0; i < statement_.size(); ++i) {
      const TextToken& t = at(i);
      if (depth == 0 && (t.is(',') || t.is(';'))) break;
      depth += t.is('(') || t.is('[') || t.is('{');
      depth -= t.is(')') || t.is(']') || t.is('}');
      if (t.isWord() && !at(i - 1).is('.')) uses_.take(t, {}, scanner_, uses);
    }
    const bool integer = global.type == "int" || global.type == "uint";
    if (global.constant && integer && global.arraySizes.empty()) {
      const std::int64_t value = evaluate(begin, i);
      if (value >= 0) constants_[global.name] = value;
    }
    return i;
  }

  std::vector<BlockMember> readMembers(std::size_t open,
                                       std::vector<std::vector<std::int64_t>>* sizes) {
    std::vector<BlockMember> members;
    const std::size_t close = closing(open);
    std::size_t i = open + 1;
    while (i < close) {
      StageGlobal ignored;
      i = readQualifiers(i, ignored);
      const std::string_view type = at(i).text;
      std::vector<std::int64_t> typeSizes;
      i = readSizes(i + 1, typeSizes);
      while (i < close && at(i).isWord()) {
        members.push_back({type, at(i).text});
        std::vector<std::int64_t> own;
        i = readSizes(i + 1, own);
        own.insert(own.end(), typeSizes.begin(), typeSizes.end());
        if (sizes) sizes->push_back(std::move(own));
        if (at(i).is(',')) ++i;
      }
      while (i < close && !at(i).is(';')) ++i;
      ++i;
    }
    return members;
  }

  void readStruct(std::size_t i, StageGlobal& global) {
    StructType type;
    if (at(i).isWord()) type.name = at(i++).text;
    if (!at(i).is('{')) return;
    type.members = readMembers(i, &type.memberSizes);
    global.type = type.name;
    out_.structs.push_back(std::move(type));
    readDeclarators(closing(i) + 1, global, {});
  }

  void readBlock(std::size_t open, StageGlobal global) {
    global.block = true;
    global.members = readMembers(open, nullptr);
    const std::size_t after = closing(open) + 1;
    if (at(after).isWord()) {
      global.name = at(after).text;
      readSizes(after + 1, global.arraySizes);
    }
    addGlobal(std::move(global));
  }

  void addGlobal(StageGlobal global) {
    std::vector<std::string_view> names;
    if (!global.name.empty()) names.push_back(global.name);
    if (global.name.empty()) {
      for (const BlockMember& member : global.members) names.push_back(member.name);
    }
    uses_.addGlobal(names);
    out_.globals.push_back(std::move(global));
  }

  // ---- functions

  void readFunction() {
    std::size_t name = statement_.size();
    for (std::size_t i = 1; i < statement_.size(); ++i) {
      if (statement_[i].is('(') && statement_[i - 1].isWord() &&
          statement_[i - 1].text != "layout") {
        name = i - 1;
        break;
      }
    }
    if (name >= statement_.size()) return readBody(nullptr);
    std::vector<std::string_view> parameters;
    for (std::size_t i = name + 2; i < statement_.size(); ++i) {
      if (at(i).isWord() && at(i - 1).isWord()) parameters.push_back(at(i).text);
    }
    readBody(uses_.beginFunction(at(name).text, std::move(parameters)));
  }

  /// `uses` null: only finds the end.
  void readBody(FunctionUses* uses) {
    int depth = 1;
    TextToken previous;
    for (TextToken token = scanner_.next(); token.kind != TextToken::Kind::End;
         token = scanner_.next()) {
      if (token.isWord()) {
        if (uses && !previous.is('.')) uses_.take(token, previous, scanner_, *uses);
      } else if (token.is('{')) {
        ++depth;
      } else if (token.is('}')) {
        if (--depth == 0) return;
      }
      previous = token;
    }
  }

  TextScanner scanner_;
  StageInterface out_;
  Statement statement_;
  StageUses uses_;
  std::unordered_map<std::string_view, std::int64_t> constants_;
};

}  // namespace

StageInterface readStageInterface(const StageText& stage) { return StageReader(stage).run(); }

const StageGlobal* findGlobal(const StageInterface& stage, Storage storage, std::string_view name) {
  const auto found =
      std::find_if(stage.globals.begin(), stage.globals.end(), [&](const StageGlobal& global) {
        return global.storage == storage && !global.block && global.name == name;
      });
  return found == stage.globals.end() ? nullptr : &*found;
}

}  // namespace orris
