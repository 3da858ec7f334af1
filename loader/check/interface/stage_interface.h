// What one stage declares at file scope and really uses, read from its final text. Text that does
// not compile is read as far as it makes sense, so that the checks work beside compiler errors.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <orris/glsl/compile/validate.h>

namespace orris {

/// A place in a final text, counted from 1.
struct TextPlace {
  int line = 0;
  int column = 0;
};

/// Numbers of a layout(...) qualifier, -1 where absent.
struct LayoutNumbers {
  int location = -1;
  int index = -1;
  int binding = -1;
  int component = -1;
};

/// A member of an interface block.
struct BlockMember {
  std::string_view type;
  std::string_view name;
};

/// A variable or interface block at file scope. The views point into the final text.
struct StageGlobal {
  enum class Storage { Plain, In, Out, Uniform, Buffer, Shared };
  enum class Interpolation { Smooth, Flat, NoPerspective };
  Storage storage = Storage::Plain;
  Interpolation interpolation = Interpolation::Smooth;
  bool patch = false;
  bool constant = false;
  LayoutNumbers layout;
  std::string_view format;  ///< of an image: "rgba16f"
  std::string_view type;    ///< of a block: its name
  std::string_view name;    ///< of a block: its instance name, may be empty
  bool block = false;
  std::vector<BlockMember> members;      ///< of a block
  std::vector<std::int64_t> arraySizes;  ///< outermost first; 0: unsized, -1: not known
  TextPlace place;                       ///< of the name
  bool initialised = false;              ///< has a value of its own
  bool used = false;                     ///< by a function that main reaches, or an initialiser
};

/// A write to gl_FragData[index] or gl_FragColor (index 0); index -1: not a literal.
struct FragDataUse {
  int index = 0;
  TextPlace place;
};

struct StructType {
  std::string_view name;
  std::vector<BlockMember> members;
  std::vector<std::vector<std::int64_t>> memberSizes;  ///< array sizes of each member
};

struct StageInterface {
  const StageText* stage = nullptr;
  std::vector<StageGlobal> globals;
  std::vector<StructType> structs;
  std::vector<FragDataUse> fragData;
};

/// Reads `stage`, which must outlive the result.
StageInterface readStageInterface(const StageText& stage);

/// The global of that name and storage, or nullptr.
const StageGlobal* findGlobal(const StageInterface& stage, StageGlobal::Storage storage,
                              std::string_view name);

}  // namespace orris
