#include "check/stage_interface.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <unordered_map>

#include "check/text_scanner.h"
#include "glsl/condition.h"
#include "glsl/outline.h"

namespace orris {
namespace {

using Statement = std::vector<TextToken>;
using Storage = StageGlobal::Storage;

/// What a word at file scope names.
struct Known {
  bool isFunction = false;
  int index = 0;
};

/// Names of file scope, with a filter that turns most other words away without hashing.
class NameTable {
 public:
  void add(std::string_view name, Known known) {
    byName_.emplace(name, known);
    lengths_[static_cast<unsigned char>(name.front())] |= lengthBit(name);
  }
  const Known* find(std::string_view name) const {
    if (!(lengths_[static_cast<unsigned char>(name.front())] & lengthBit(name))) return nullptr;
    const auto found = byName_.find(name);
    return found == byName_.end() ? nullptr : &found->second;
  }

 private:
  static std::uint64_t lengthBit(std::string_view name) {
    return std::uint64_t{1} << std::min<std::size_t>(name.size(), 63);
  }
  std::unordered_map<std::string_view, Known> byName_;
  std::array<std::uint64_t, 256> lengths_{};
};

/// What the body of a function (all overloads of a name together), or an initialiser, mentions.
struct FunctionUses {
  std::vector<int> calls;
  std::vector<int> globals;
  std::vector<FragDataUse> fragData;
  bool reached = false;
};

int toInt(std::string_view text) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : -1;
}

class StageReader {
 public:
  explicit StageReader(const StageText& stage) : scanner_(stage.text.text) { out_.stage = &stage; }

  StageInterface run() {
    names_.add("gl_FragData", {false, kFragData});
    names_.add("gl_FragColor", {false, kFragColor});
    while (readStatement()) {
    }
    markReached();
    return std::move(out_);
  }

 private:
  static constexpr int kFragData = -1, kFragColor = -2;

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
    if (at(i).isWord() && at(i + 1).is('(')) return addFunctionName(at(i).text);
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
    using Interpolation = StageGlobal::Interpolation;
    if (word == "in" || word == "attribute") global.storage = Storage::In;
    if (word == "out") global.storage = Storage::Out;
    if (word == "uniform") global.storage = Storage::Uniform;
    if (word == "buffer") global.storage = Storage::Buffer;
    if (word == "shared") global.storage = Storage::Shared;
    if (word == "flat") global.interpolation = Interpolation::Flat;
    if (word == "noperspective") global.interpolation = Interpolation::NoPerspective;
    global.patch |= word == "patch";
    global.constant |= word == "const";
  }

  void readLayout(std::size_t open, StageGlobal& global) {
    struct Row {
      std::string_view word;
      int LayoutNumbers::*field;
    };
    static constexpr Row kRows[] = {{"location", &LayoutNumbers::location},
                                    {"index", &LayoutNumbers::index},
                                    {"binding", &LayoutNumbers::binding},
                                    {"component", &LayoutNumbers::component}};
    const std::size_t close = closing(open);
    for (std::size_t i = open + 1; i < close; ++i) {
      if (!at(i).isWord()) continue;
      const auto row = std::find_if(std::begin(kRows), std::end(kRows),
                                    [&](const Row& r) { return r.word == at(i).text; });
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
      initialisers_.back() = std::move(initialiser);
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
      if (t.isWord() && !at(i - 1).is('.')) takeWord(t, {}, uses);
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
    const int index = static_cast<int>(out_.globals.size());
    if (!global.name.empty()) names_.add(global.name, {false, index});
    if (global.name.empty()) {
      for (const BlockMember& member : global.members) names_.add(member.name, {false, index});
    }
    out_.globals.push_back(std::move(global));
    initialisers_.emplace_back();
  }

  // ---- functions

  void addFunctionName(std::string_view name) {
    if (const Known* known = names_.find(name); known && known->isFunction) return;
    names_.add(name, {true, static_cast<int>(functions_.size())});
    functions_.emplace_back();
  }

  void readFunction() {
    std::size_t name = statement_.size();
    for (std::size_t i = 1; i < statement_.size(); ++i) {
      if (statement_[i].is('(') && statement_[i - 1].isWord() &&
          statement_[i - 1].text != "layout") {
        name = i - 1;
        break;
      }
    }
    hidden_.clear();
    if (name >= statement_.size()) return readBody(nullptr);
    addFunctionName(at(name).text);
    const Known* known = names_.find(at(name).text);
    const int index = known && known->isFunction ? known->index : -1;
    if (at(name).text == "main" && index >= 0) roots_.push_back(index);
    for (std::size_t i = name + 2; i < statement_.size(); ++i) {
      if (at(i).isWord() && at(i - 1).isWord()) hidden_.push_back(at(i).text);
    }
    readBody(index < 0 ? nullptr : &functions_[static_cast<std::size_t>(index)]);
  }

  /// `uses` null: only finds the end.
  void readBody(FunctionUses* uses) {
    int depth = 1;
    TextToken previous;
    for (TextToken token = scanner_.next(); token.kind != TextToken::Kind::End;
         token = scanner_.next()) {
      if (token.isWord()) {
        if (uses && !previous.is('.')) takeWord(token, previous, *uses);
      } else if (token.is('{')) {
        ++depth;
      } else if (token.is('}')) {
        if (--depth == 0) return;
      }
      previous = token;
    }
  }

  void takeWord(const TextToken& word, const TextToken& previous, FunctionUses& uses) {
    const Known* known = names_.find(word.text);
    if (!known) return;
    if (known->isFunction) return addOnce(uses.calls, known->index);
    if (known->index < 0) return takeFragData(word, known->index, uses);
    if (declaresLocal(previous)) hidden_.push_back(word.text);
    if (std::find(hidden_.begin(), hidden_.end(), word.text) != hidden_.end()) return;
    addOnce(uses.globals, known->index);
  }

  static void addOnce(std::vector<int>& list, int value) {
    if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
  }

  // "float name": a type before the word.
  static bool declaresLocal(const TextToken& previous) {
    return previous.isWord() && previous.text != "return" && previous.text != "else";
  }

  void takeFragData(const TextToken& word, int which, FunctionUses& uses) {
    FragDataUse use{0, {word.line, word.column}};
    if (which == kFragData) {
      TextScanner ahead = scanner_;
      const bool indexed = ahead.next().is('[');
      const TextToken number = ahead.next();
      use.index = indexed && ahead.next().is(']') ? toInt(number.text) : -1;
    }
    uses.fragData.push_back(use);
  }

  void markReached() {
    for (const int root : roots_) reachFunction(root);
    while (!open_.empty()) {
      const FunctionUses* uses = open_.back();
      open_.pop_back();
      for (const int global : uses->globals) reachGlobal(static_cast<std::size_t>(global));
      out_.fragData.insert(out_.fragData.end(), uses->fragData.begin(), uses->fragData.end());
      for (const int call : uses->calls) reachFunction(call);
    }
  }

  void reachFunction(int index) {
    FunctionUses& uses = functions_[static_cast<std::size_t>(index)];
    if (!uses.reached) open_.push_back(&uses);
    uses.reached = true;
  }

  void reachGlobal(std::size_t index) {
    if (!out_.globals[index].used) open_.push_back(&initialisers_[index]);
    out_.globals[index].used = true;
  }

  TextScanner scanner_;
  StageInterface out_;
  Statement statement_;
  NameTable names_;
  std::vector<FunctionUses> functions_;
  std::vector<FunctionUses> initialisers_;  ///< of each global
  std::vector<int> roots_;
  std::vector<const FunctionUses*> open_;  ///< reached, not yet followed
  std::vector<std::string_view> hidden_;   ///< locals and parameters of the function being read
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
