// Typed, bounded values out of located JSON; every mismatch becomes a located error.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include <orris/core/message_limits.h>
#include <orris/world/blocks/block_state.h>
#include <orris/world/files/located_json.h>

namespace orris {

struct IntegerRange {
  std::int64_t low = 0, high = 0;
};
struct RealRange {
  double low = 0, high = 0;
};

/// `what` names the value in messages ("a camera", "\"time\"").
class JsonReader {
 public:
  JsonReader(const JsonText& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  /// Of many errors the first are kept.
  void error(std::size_t offset, std::string message, std::string hint = "");
  /// The error that `node` is something else than `expectation`.
  void expected(const JsonNode& node, const std::string& what, const std::string& expectation);
  bool failed() const { return failed_; }

  /// An object that has no other keys than `keys`.
  bool object(const JsonNode& node, const std::string& what, const std::vector<std::string>& keys);
  bool array(const JsonNode& node, const std::string& what);
  /// The member, with an error when it is missing.
  const JsonNode* required(const JsonNode& object, const std::string& key, const std::string& what);

  std::optional<int> integer(const JsonNode& node, const std::string& what, IntegerRange range);
  std::optional<double> number(const JsonNode& node, const std::string& what, RealRange range);
  std::optional<std::string> string(const JsonNode& node, const std::string& what);
  std::optional<glm::ivec3> cell(const JsonNode& node, const std::string& what, IntegerRange range);
  std::optional<glm::dvec3> vector(const JsonNode& node, const std::string& what, RealRange range);
  std::optional<BlockState> block(const JsonNode& node, const std::string& what);

  // Members that may be absent: `target` keeps its value then.
  void optional(const JsonNode& object, const std::string& key, IntegerRange range, int& target);
  void optional(const JsonNode& object, const std::string& key, RealRange range, float& target);
  void optional(const JsonNode& object, const std::string& key, RealRange range, double& target);
  void optional(const JsonNode& object, const std::string& key, RealRange range, glm::vec3& target);
  void optional(const JsonNode& object, const std::string& key, std::string& target);
  void optional(const JsonNode& object, const std::string& key, bool& target);

  const JsonText& source() const { return source_; }
  Diagnostics& diagnostics() { return diagnostics_; }

 private:
  const JsonText& source_;
  Diagnostics& diagnostics_;
  MessageBudget budget_;
  std::size_t errors_ = 0;
  bool failed_ = false;
};

}  // namespace orris
