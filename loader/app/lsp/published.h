// Findings as an editor shows them: which file has which, what differs from what is shown, and the edits
// that mend them.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/lsp/edited_pack.h"

namespace orris {

class Published {
 public:
  /// `send` publishes the diagnostics of a URI.
  using Send = std::function<void(const std::string& uri, nlohmann::json diagnostics)>;

  /// Of the whole pack.
  void show(EditedPack& pack, nlohmann::json findings, bool utf8, const Send& send);
  /// Errors of these stages take the place of those shown that concern one of their programs; the rest stays.
  void showErrors(EditedPack& pack, const std::set<std::string>& stages, const nlohmann::json& findings,
                  bool utf8, const Send& send);
  /// Code actions for lines of a file (a path).
  nlohmann::json actions(EditedPack& pack, const std::string& path, int first, int last, bool utf8) const;

 private:
  void send(EditedPack& pack, bool utf8, const Send& send);
  nlohmann::json findings_ = nlohmann::json::array();
  std::map<std::string, nlohmann::json> shown_;  ///< by URI
};

}  // namespace orris
