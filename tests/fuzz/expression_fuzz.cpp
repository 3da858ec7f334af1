// libFuzzer target: each line is the expression of one custom uniform; all are evaluated twice.
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>

#include <orris/pack/expressions/expression.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orris;
  constexpr int kTypes = 6, kMostEntries = 64;
  std::istringstream stream(std::string(reinterpret_cast<const char*>(data), size));
  std::vector<CustomUniform> entries;
  for (std::string line; std::getline(stream, line) && entries.size() < kMostEntries;) {
    const int number = static_cast<int>(entries.size());
    entries.push_back({.name = "u" + std::to_string(number),
                       .type = static_cast<ValueType>(number % kTypes),
                       .expression = line,
                       .at = {"/shaders.properties", number + 1, 1},
                       .lines = {line}});
  }
  const auto type = [](const std::string& name) -> std::optional<ValueType> {
    if (name == "i") return ValueType::Int;
    if (name == "b") return ValueType::Bool;
    if (name == "v") return ValueType::Vec3;
    if (name == "m") return ValueType::Mat4;
    return name == "f" ? std::optional(ValueType::Float) : std::nullopt;
  };
  const auto value = [](const std::string&) {
    Value all;
    all.f.fill(-1.5f);
    all.i.fill(-7);
    return all;
  };
  Diagnostics diagnostics;
  CustomUniforms uniforms(entries, type, diagnostics);
  uniforms.evaluate(value, 0.016f, 1);
  uniforms.evaluate(value, 0.016f, 2);
  return 0;
}
