// What the functions of a stage mention, and what of it its main() reaches.
#pragma once

#include <array>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <orris/check/compile/text_scanner.h>
#include <orris/check/interface/stage_interface.h>

namespace orris {

/// What the body of a function (all overloads of a name together), or an initialiser, mentions.
struct FunctionUses {
  std::vector<int> calls;
  std::vector<int> globals;
  std::vector<FragDataUse> fragData;
  bool reached = false;
};

/// Names live in the stage's text.
class StageUses {
 public:
  StageUses();
  /// The next global of the stage, with all names by which it is used.
  void addGlobal(const std::vector<std::string_view>& names);
  /// Of the last global.
  void setInitialiser(FunctionUses uses) { initialisers_.back() = std::move(uses); }
  void addFunction(std::string_view name);
  /// Where to put what its body mentions, until the next call; nullptr when the name is another's.
  FunctionUses* beginFunction(std::string_view name, std::vector<std::string_view> parameters);
  /// A word of a body or an initialiser, the token before it and the scanner behind it.
  void take(const TextToken& word, const TextToken& previous, const TextScanner& behind,
            FunctionUses& uses);
  /// Marks the globals that main() reaches, and lists its uses of gl_FragData.
  void markReached(StageInterface& stage);

 private:
  /// What a word at file scope names.
  struct Known {
    bool isFunction = false;
    int index = 0;
  };
  /// Names of file scope, with a filter that turns most other words away without hashing.
  class NameTable {
   public:
    void add(std::string_view name, Known known);
    const Known* find(std::string_view name) const;

   private:
    std::unordered_map<std::string_view, Known> byName_;
    std::array<std::uint64_t, 256> lengths_{};
  };

  void reachFunction(int index);

  NameTable names_;
  std::vector<FunctionUses> functions_;
  std::vector<FunctionUses> initialisers_;  ///< of each global
  std::vector<int> roots_;
  std::vector<const FunctionUses*> open_;  ///< reached, not yet followed
  std::vector<std::string_view> hidden_;   ///< locals and parameters of the function being read
};

}  // namespace orris
