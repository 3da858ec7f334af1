#include <orris/check/interface/stage_uses.h>

#include <algorithm>
#include <charconv>
#include <utility>

namespace orris {
namespace {

constexpr int kFragData = -1, kFragColor = -2;

std::uint64_t lengthBit(std::string_view name) {
  return std::uint64_t{1} << std::min<std::size_t>(name.size(), 63);
}

int toInt(std::string_view text) {
  int value = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? value : -1;
}

void addOnce(std::vector<int>& list, int value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

// "float name": a type before the word.
bool declaresLocal(const TextToken& previous) {
  return previous.isWord() && previous.text != "return" && previous.text != "else";
}

FragDataUse fragDataUse(const TextToken& word, int which, TextScanner ahead) {
  FragDataUse use{0, {word.line, word.column}};
  if (which == kFragColor) return use;
  const bool indexed = ahead.next().is('[');
  const TextToken number = ahead.next();
  use.index = indexed && ahead.next().is(']') ? toInt(number.text) : -1;
  return use;
}

}  // namespace

void StageUses::NameTable::add(std::string_view name, Known known) {
  byName_.emplace(name, known);
  lengths_[static_cast<unsigned char>(name.front())] |= lengthBit(name);
}

const StageUses::Known* StageUses::NameTable::find(std::string_view name) const {
  if (!(lengths_[static_cast<unsigned char>(name.front())] & lengthBit(name))) return nullptr;
  const auto found = byName_.find(name);
  return found == byName_.end() ? nullptr : &found->second;
}

StageUses::StageUses() {
  names_.add("gl_FragData", {false, kFragData});
  names_.add("gl_FragColor", {false, kFragColor});
}

void StageUses::addGlobal(const std::vector<std::string_view>& names) {
  const int index = static_cast<int>(initialisers_.size());
  for (const std::string_view name : names) names_.add(name, {false, index});
  initialisers_.emplace_back();
}

void StageUses::addFunction(std::string_view name) {
  if (const Known* known = names_.find(name); known && known->isFunction) return;
  names_.add(name, {true, static_cast<int>(functions_.size())});
  functions_.emplace_back();
}

FunctionUses* StageUses::beginFunction(std::string_view name,
                                       std::vector<std::string_view> parameters) {
  hidden_ = std::move(parameters);
  addFunction(name);
  const Known* known = names_.find(name);
  if (!known || !known->isFunction) return nullptr;
  if (name == "main") roots_.push_back(known->index);
  return &functions_[static_cast<std::size_t>(known->index)];
}

void StageUses::take(const TextToken& word, const TextToken& previous, const TextScanner& behind,
                     FunctionUses& uses) {
  const Known* known = names_.find(word.text);
  if (!known) return;
  if (known->isFunction) return addOnce(uses.calls, known->index);
  if (known->index < 0) return uses.fragData.push_back(fragDataUse(word, known->index, behind));
  if (declaresLocal(previous)) hidden_.push_back(word.text);
  if (std::find(hidden_.begin(), hidden_.end(), word.text) != hidden_.end()) return;
  addOnce(uses.globals, known->index);
}

void StageUses::markReached(StageInterface& stage) {
  for (const int root : roots_) reachFunction(root);
  while (!open_.empty()) {
    const FunctionUses* uses = open_.back();
    open_.pop_back();
    for (const int index : uses->globals) {
      StageGlobal& global = stage.globals[static_cast<std::size_t>(index)];
      if (!std::exchange(global.used, true))
        open_.push_back(&initialisers_[static_cast<std::size_t>(index)]);
    }
    stage.fragData.insert(stage.fragData.end(), uses->fragData.begin(), uses->fragData.end());
    for (const int call : uses->calls) reachFunction(call);
  }
}

void StageUses::reachFunction(int index) {
  FunctionUses& uses = functions_[static_cast<std::size_t>(index)];
  if (!std::exchange(uses.reached, true)) open_.push_back(&uses);
}

}  // namespace orris
