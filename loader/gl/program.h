// Compiling, linking and asking a program what it uses.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orris/gl/handle.h>

namespace orris::gl {

struct ActiveVariable {
  std::string name;   ///< array suffix "[0]" dropped
  unsigned type = 0;  ///< GL enum
  int size = 1;
  int location = -1;  ///< -1: built-in or block member
};

struct StageSource {
  unsigned type = 0;  ///< GL_VERTEX_SHADER, ...
  std::string_view text;
};

/// A linked program, or logs and id 0. `stageLogs` and `stageFailed` follow the order of the
/// sources; a stage that failed leaves the program unlinked with an empty link log.
struct Program {
  Handle<deleteProgram> handle;
  std::vector<ActiveVariable> uniforms;  ///< samplers and images included
  std::vector<ActiveVariable> attributes;
  int storageBlocks = 0;                 ///< active ones
  std::vector<int> computeLocalSize;  ///< 3 values for a compute program
  std::vector<std::string> stageLogs;
  std::vector<bool> stageFailed;
  std::string linkLog;
  bool linked = false;
  double compileSeconds = 0, linkSeconds = 0;
  unsigned id() const { return handle.id(); }
};

/// `fragmentOutputs` (slot names, e.g. "outColor0") are bound to their index before linking.
Program buildProgram(const std::vector<StageSource>& sources,
                     const std::vector<std::pair<std::string, int>>& fragmentOutputs,
                     const std::string& label);

bool isSampler(unsigned type);
bool isShadowSampler(unsigned type);
bool isImage(unsigned type);
/// 1, 2 or 3 for sampler and image types; 0 where no texture of ours fits (cube, array, buffer).
int dimensionsOf(unsigned type);

}  // namespace orris::gl
