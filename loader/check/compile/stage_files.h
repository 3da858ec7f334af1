// Which files the text of a stage comes from, and where in it.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <orris/check/hints/definition_index.h>
#include <orris/glsl/compile/validate.h>

namespace orris {

/// The files that give the stage its first `last` lines (0: all), in the order of their text: not those
/// of an #include in a branch that is not read.
std::vector<std::string> filesOf(DefinitionIndex& index, const StageText& stage,
                                 std::size_t last = 0);

/// The first line of the stage's text that comes from a place, 0 when none does.
std::size_t lineOf(const StageText& stage, const SourceLocation& at);

}  // namespace orris
