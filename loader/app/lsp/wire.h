// Messages of the Language Server Protocol over file descriptors: a header with the length, then JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace orris {

class LspWire {
 public:
  LspWire(int in, int out) : in_(in), out_(out) {}

  int in() const { return in_; }
  /// Reads what there is; waits only where there is nothing. false: the other end is closed.
  bool fill();
  /// The next whole message; nullopt: more must be read. A body that is no JSON is an empty object, a
  /// header without a length that can be taken closes the wire.
  std::optional<nlohmann::json> next();
  void send(const nlohmann::json& message);
  bool broken() const { return broken_; }

 private:
  int in_, out_;
  std::string read_;
  bool broken_ = false;
};

}  // namespace orris
