#include <orris/pack/ids/block_history.h>

#include <functional>
#include <map>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

struct Change {
  Version version;
  std::string_view added, removed;  ///< names between blanks
};
constexpr Change kChanges[] = {
#include <orris/pack/ids/block_history.inc>
};

using Lives = std::map<std::string, BlockLife, std::less<>>;

const Lives& lives() {
  static const Lives kLives = [] {
    Lives all;
    for (const Change& change : kChanges) {
      for (std::string& name : splitBlanks(change.added))
        all.emplace(std::move(name), BlockLife{change.version, std::nullopt});
      for (const std::string& name : splitBlanks(change.removed))
        all.at(name).until = change.version;
    }
    return all;
  }();
  return kLives;
}

}  // namespace

const BlockLife* findBlockLife(std::string_view name) {
  const auto found = lives().find(name);
  return found == lives().end() ? nullptr : &found->second;
}

const std::vector<std::string>& allBlockNames() {
  static const std::vector<std::string> kNames = [] {
    std::vector<std::string> names;
    for (const auto& [name, life] : lives()) names.push_back(name);
    return names;
  }();
  return kNames;
}

}  // namespace orris
