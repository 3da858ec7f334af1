// Shapes of programs (glsl/tokens/shape.h): which variants of a matrix need not be compiled, and which not
// even preprocessed.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orris/check/matrix/matrix_plan.h>

namespace orris {

/// What a unit is known by: its shape, or that of each of its stages together. Those of the compute
/// shaders first, as in programUnits().
using UnitShapes = std::vector<std::uint64_t>;
std::vector<std::string> filesOf(const ProgramEntry& entry);
UnitShapes unitShapes(const ProgramEntry& entry, const std::vector<std::uint64_t>& parts);

/// A program with the values in force.
struct BaseProgram {
  const ProgramSource* source = nullptr;
  std::vector<std::string> files;                 ///< of each part
  std::vector<std::uint64_t> parts;               ///< shape of each
  std::vector<std::vector<std::string>> options;  ///< that each depends on, sorted
  UnitShapes units;
};

/// Those programs that a plan has jobs for.
class BaseShapes {
 public:
  BaseShapes(const MatrixBase& base, const MatrixPlan& plan);
  const BaseProgram* find(const MatrixJob& job) const;
  const std::map<std::pair<std::size_t, std::string>, BaseProgram>& all() const {
    return programs_;
  }

 private:
  std::map<std::pair<std::size_t, std::string>, BaseProgram> programs_;
};

/// An option that no condition asks for and that takes one number for another puts these into the
/// text and changes nothing else. When two of its values give one shape, the number stands only where
/// its kind counts, and all values of that kind give that shape.
class NumberSweeps {
 public:
  NumberSweeps(const MatrixPlan& plan, const BaseShapes& shapes) : plan_(plan), shapes_(shapes) {}

  /// The shapes of `job`, when values tried before tell them.
  std::optional<UnitShapes> known(const MatrixJob& job);
  /// What building `job` gave.
  void learn(const MatrixJob& job, const UnitShapes& units);

 private:
  struct Sweep {
    UnitShapes units;
    int values = 0;
    bool differs = false;
  };
  Sweep* sweepOf(const MatrixJob& job);

  const MatrixPlan& plan_;
  const BaseShapes& shapes_;
  std::map<std::string, Sweep> sweeps_;
};

}  // namespace orris
