// The expression language of custom uniforms (uniform.* and variable.* in shaders.properties).
// Contract: expressions.csv.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>

namespace orris {

enum class ValueType { Bool, Int, Float, Vec2, Vec3, Vec4, IVec2, IVec3, Mat3, Mat4 };

/// A value of any uniform type; matrices are column-major in `f`.
struct Value {
  ValueType type = ValueType::Float;
  std::array<float, 16> f{};  ///< Float, VecN, MatN
  std::array<int, 4> i{};     ///< Bool, Int, IVecN
  static Value ofInt(int v);
  static Value ofBool(bool v);
  static Value ofFloat(float v);
  bool operator==(const Value&) const = default;
};

/// One uniform.<type>.<name> or variable.<type>.<name> line.
struct CustomUniform {
  std::string name;
  ValueType type = ValueType::Float;
  bool uploaded = true;  ///< false for variable.*
  std::string expression;
  SourceLocation at;               ///< of the key
  std::vector<std::string> lines;  ///< as written, from that of the key on; never empty
};

/// Inputs by name, for type checking (nullopt: unknown) and for values.
using InputTypes = std::function<std::optional<ValueType>(const std::string&)>;
using InputValues = std::function<Value(const std::string&)>;

/// All custom uniforms of a pack, compiled once, evaluated once per frame in dependency order.
class CustomUniforms {
 public:
  /// An entry that does not parse or type-check is dropped with a located warning, with everything
  /// that depends on it; a dependency cycle is an error.
  CustomUniforms(const std::vector<CustomUniform>& entries, const InputTypes& inputs,
                 Diagnostics& diagnostics);
  ~CustomUniforms();
  CustomUniforms(CustomUniforms&&) noexcept;
  CustomUniforms& operator=(CustomUniforms&&) noexcept;

  /// Evaluates every entry; `frameTime` in seconds drives smooth(); `seed` drives random().
  void evaluate(const InputValues& inputs, float frameTime, unsigned seed);
  /// Uploaded entries with their current values, in evaluation order.
  const std::vector<std::pair<std::string, Value>>& values() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace orris
