#include <orris/glsl/preprocess/conditionals.h>

#include <algorithm>
#include <utility>

namespace orris {
namespace {

bool isGuard(const Conditionals::Open& open) {
  return open.firstOfFile && open.directive == "ifndef";
}

}  // namespace

void Conditionals::open(const Origin& at, const std::string& directive, bool condition) {
  const bool parent = active();
  const bool first = sites_.insert(at.site).second;
  stack_.push_back(
      {at, directive, parent, parent && condition, condition, false, first, closed_.size()});
}

std::string Conditionals::elif (bool condition) {
  if (stack_.empty()) return "#elif without #if";
  Open& top = stack_.back();
  if (top.sawElse) {
    top.active = false;
    return "#elif after #else";
  }
  top.active = top.parentActive && !top.taken && condition;
  top.taken = top.taken || condition;
  return "";
}

std::string Conditionals::otherwise() {
  if (stack_.empty()) return "#else without #if";
  Open& top = stack_.back();
  if (top.sawElse) {
    top.active = false;
    return "#else after #else";
  }
  top.active = top.parentActive && !top.taken;
  top.taken = true;
  top.sawElse = true;
  return "";
}

std::string Conditionals::close(const Origin& at) {
  if (stack_.empty()) return "#endif without #if";
  closed_.push_back({std::move(stack_.back()), at});
  stack_.pop_back();
  return "";
}

std::vector<Conditionals::Open> Conditionals::unclosed() const {
  std::vector<Open> result;
  for (const Open& open : stack_) result.push_back(meantBy(open));
  return result;
}

Conditionals::Open Conditionals::meantBy(const Open& open) const {
  const Closed* last = nullptr;
  for (std::size_t i = open.closedBefore; i < closed_.size(); ++i) {
    const Closed& pair = closed_[i];
    if (pair.open.at.site > pair.close.site) return pair.open;
    if (pair.open.at.column > pair.close.column) return pair.open;
    if (pair.open.at.site == open.at.site) last = &pair;
  }
  return last && isGuard(open) ? last->open : open;
}

Origin Conditionals::strayClose(const Origin& at) const {
  const auto isMeant = [&at](const Closed& pair) {
    if (pair.open.at.site < pair.close.site) return true;
    if (pair.close.site != at.site) return false;
    return pair.open.at.column < pair.close.column || isGuard(pair.open);
  };
  const auto found = std::ranges::find_if(closed_, isMeant);
  return found == closed_.end() ? at : found->close;
}

}  // namespace orris
