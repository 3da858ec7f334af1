// What the workers of a matrix do: build one program under one set of values and compile what is
// new of it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <orris/check/matrix/matrix_plan.h>
#include <orris/check/matrix/matrix_shapes.h>
#include <orris/check/workers/shared_hashes.h>

namespace orris {

/// What one program of one configuration gave.
struct MatrixFinding {
  std::vector<std::uint64_t> units;  ///< shapes of its units (check/matrix/matrix_shapes.h)
  std::map<std::uint64_t, Diagnostics> failing;  ///< errors of those compiled here that have any
  int compiled = 0;                              ///< units that nobody had compiled before
  Diagnostics errors;                            ///< of building it, not of compiling it
};

std::string encode(const MatrixFinding& finding);
MatrixFinding decodeFinding(const std::string& bytes);

class MatrixWorker {
 public:
  /// `seen` holds the units that somebody compiled.
  MatrixWorker(const MatrixPlan& plan, const BaseShapes& shapes,
               const MacroDefinitions& environment, SharedHashes& seen)
      : plan_(plan),
        shapes_(shapes),
        seen_(seen),
        sweeps_(plan, shapes),
        variants_(plan, environment) {}

  /// Compiles units that nobody has compiled yet.
  MatrixFinding run(const MatrixJob& job);
  /// What the compiler says of one unit of `job`.
  Diagnostics unitErrors(const MatrixJob& job, std::size_t unit);
  /// Errors of the program of `job` (or of the properties) under `values`, compiler's included.
  Diagnostics errorsWith(const MatrixJob& job, const OptionValues& values);
  /// Options that decide about the program under `values`: conditions in its text and properties.
  std::vector<std::string> deciding(const MatrixJob& job, const OptionValues& values);

 private:
  struct Variant {
    std::vector<std::optional<PreprocessedPart>> parts;  ///< none: as with the values in force
    std::vector<std::uint64_t> shapes;
    bool failed = false;  ///< a part has errors
  };
  Variant shapesOf(const MatrixJob& job, const FolderBuild& build) const;
  bool isClean(const MatrixJob& job, const UnitShapes& units) const;
  ProgramSource finish(const MatrixJob& job, const FolderBuild& build, Variant variant) const;
  void compileNew(const ProgramSource& program, const FolderBuild& build, MatrixFinding& finding);

  const MatrixPlan& plan_;
  const BaseShapes& shapes_;
  SharedHashes& seen_;
  NumberSweeps sweeps_;
  MatrixVariants variants_;
  std::set<std::tuple<std::size_t, std::string, UnitShapes>> clean_;  ///< build, program
};

}  // namespace orris
