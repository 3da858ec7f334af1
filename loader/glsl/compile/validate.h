// glslang over the host's own output; verdicts are mapped back to the author's lines.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/glsl/rewrite/rewrite.h>

namespace orris {

/// A stage as it goes to the compiler.
struct StageText {
  Stage stage = Stage::Vertex;
  MappedText text;
};

/// Gives the author's line ("" when unknown), so that a diagnostic can show it with a caret.
using SourceLines = std::function<std::string(const std::string& file, int line)>;

/// Which errors of a stage are wanted: the first one hides what may follow from it.
enum class CompileErrors { All, First };

/// Compiles each stage and links the program with glslang, its interfaces repaired as Iris does it
/// (glsl/rewrite/interface_repair.h). Thread-safe.
void validateWithGlslang(const std::vector<const StageText*>& stages, const SourceLines& lines,
                         Diagnostics& diagnostics, CompileErrors wanted = CompileErrors::All);

/// Maps the info log of a GL driver (Mesa, NVIDIA, AMD, Apple and Intel forms) for `stage` back to
/// the author's lines; lines of the log that carry no position become one unlocated diagnostic at
/// the stage's entry file. Returns nothing for an empty log.
void mapDriverLog(const std::string& log, Severity fallback, const StageText& stage,
                  const SourceLines& lines, Diagnostics& diagnostics);

}  // namespace orris
