// orris options --graph: the pass graph into a file, in the form that its extension asks for.
#pragma once

#include <string>

#include "app/output/report.h"
#include <orris/pack/shader_pack.h>

namespace orris {

/// Writes the graph of `pack`, called `title`, to `path`: .json, .dot, .md, or a picture (.svg, .png, .pdf) drawn by
/// Graphviz's dot; "-" prints Markdown on standard output. False: reported.
bool writeGraph(const ShaderPack& pack, const std::string& title, const std::string& path,
                Report& report);

}  // namespace orris
