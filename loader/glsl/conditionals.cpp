#include "glsl/conditionals.h"

namespace orris {

void Conditionals::open(const Origin& at, const std::string& directive, bool condition) {
  const bool parent = active();
  stack_.push_back({at, directive, parent, parent && condition, condition, false});
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

std::string Conditionals::close() {
  if (stack_.empty()) return "#endif without #if";
  stack_.pop_back();
  return "";
}

}  // namespace orris
