#include "app/commands/graph.h"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>

#include "app/input/inputs.h"
#include "app/output/child_process.h"
#include <orris/check/graph/pass_graph.h>

namespace orris {
namespace {

// As validate: decides nothing but sizes in pixels.
constexpr int kAssumedWidth = 1920, kAssumedHeight = 1080;
constexpr std::chrono::seconds kLongestLayout{120};

using TextForm = std::string (*)(const PassGraph&);
TextForm textForm(const std::string& extension) {
  if (extension == ".json") return toJsonText;
  if (extension == ".dot" || extension == ".gv") return toDot;
  if (extension == ".md") return toMarkdown;
  return nullptr;
}

std::optional<std::string> layOut(const std::string& dot, const std::string& format, Report& report) {
  const auto result = runChild({"dot", "-T" + format}, dot, kLongestLayout);
  if (!result) {
    report.error("file-unwritable", "no temporary file can be made for Graphviz");
    return std::nullopt;
  }
  if (result->missing) {
    report.error("graphviz-missing", "the program dot of Graphviz is not installed",
                 "install graphviz, or write .dot, .md or .json");
    return std::nullopt;
  }
  if (!result->succeeded()) {
    report.error("graphviz-failed",
                 fmt::format("dot did not draw the graph: {}",
                             result->exitStatus ? result->errors : "it was stopped"),
                 "write .dot, .md or .json");
    return std::nullopt;
  }
  return result->output;
}

}  // namespace

bool writeGraph(const ShaderPack& pack, const std::string& title, const std::string& path,
                Report& report) {
  const std::string extension = std::filesystem::path(path).extension();
  const TextForm form = path == "-" ? toMarkdown : textForm(extension);
  const bool picture = extension == ".svg" || extension == ".png" || extension == ".pdf";
  if (form == nullptr && !picture) {
    report.error("graph-format-unknown", fmt::format("{} is no form of a graph", path),
                 "write .svg, .png, .pdf, .dot, .json or .md, or - for a table", path);
    return false;
  }
  Diagnostics diagnostics;
  const Schedule schedule = buildSchedule(pack, kAssumedWidth, kAssumedHeight, {}, diagnostics);
  report.add(diagnostics);
  PassGraph graph = passGraph(pack, schedule);
  graph.pack = title;
  if (path == "-") {
    printText(form(graph));
    return true;
  }
  if (!checkWritable(path, report)) return false;
  const auto text = picture ? layOut(toDot(graph), extension.substr(1), report)
                            : std::optional(form(graph));
  if (!text || !writeWholeFile(path, *text, report)) return false;
  sayWritten(report.output(), {path});
  return true;
}

}  // namespace orris
