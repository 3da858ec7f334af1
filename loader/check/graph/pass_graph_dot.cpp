// The pass graph for Graphviz.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include <orris/check/graph/pass_graph.h>

namespace orris {
namespace {

struct GroupStyle {
  std::string_view group, fill;
};
constexpr GroupStyle kStyles[] = {{"setup", "#eceff1"},     {"begin", "#f3e5f5"},
                                  {"shadow", "#cfd8dc"},    {"shadowcomp", "#d7ccc8"},
                                  {"prepare", "#fff8e1"},   {"gbuffers", "#e8f5e9"},
                                  {"deferred", "#e3f2fd"},  {"translucent", "#e0f7fa"},
                                  {"composite", "#ede7f6"}, {"final", "#fce4ec"}};

// Distinct on white; a buffer keeps its colour over the whole picture.
constexpr std::string_view kEdgeColors[] = {
    "#1565c0", "#c62828", "#2e7d32", "#ef6c00", "#6a1b9a", "#00838f", "#ad1457", "#558b2f",
    "#4e342e", "#283593", "#d84315", "#00695c", "#9e9d24", "#5d4037", "#455a64", "#7b1fa2"};

std::string escape(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return out;
}

std::string_view edgeColor(const std::string& buffer) {
  const size_t digits = buffer.find_last_not_of("0123456789") + 1;
  if (digits >= buffer.size()) return "#616161";
  return kEdgeColors[static_cast<size_t>(buffer[buffer.size() - 1] - '0') % 16];
}

/// "colortex0, 3, 5": the long word once.
std::string shortList(const std::set<std::string>& buffers) {
  std::string text, previous;
  std::vector<std::string> sorted(buffers.begin(), buffers.end());
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
    return std::pair(a.size(), a) < std::pair(b.size(), b);
  });
  for (const std::string& buffer : sorted) {
    const size_t digits = buffer.find_last_not_of("0123456789") + 1;
    const std::string word = buffer.substr(0, digits);
    text += (text.empty() ? "" : ", ") + (word == previous ? buffer.substr(digits) : buffer);
    previous = word;
  }
  return text;
}

/// Passes that one box shows: geometry programs that read and draw to the same.
struct Box {
  std::vector<const GraphPass*> passes;
  std::string group;
};

struct Edge {
  size_t from = 0, to = 0;  ///< boxes
  bool history = false;     ///< what the last frame drew
  bool wholeGroup = false;  ///< from all boxes of the group of `from`
  auto operator<=>(const Edge&) const = default;
};

class DotWriter {
 public:
  explicit DotWriter(const PassGraph& graph) : graph_(graph) {
    for (const GraphPass& pass : graph.passes)
      if (pass.kind != "copy") place(pass);
  }

  std::string write() {
    out_ =
        "digraph frame {\n"
        "  graph [rankdir=TB, compound=true, ranksep=0.35, nodesep=0.3, fontname=\"Helvetica\", "
        "fontsize=12, "
        "style=\"rounded\", color=\"#90a4ae\", labelloc=t, label=<" +
        title() +
        ">];\n"
        "  node [shape=plain, fontname=\"Helvetica\", fontsize=10];\n"
        "  edge [fontname=\"Helvetica\", fontsize=8, arrowsize=0.6];\n";
    for (size_t begin = 0; begin < boxes_.size();) {
      size_t end = begin;
      while (end < boxes_.size() && boxes_[end].group == boxes_[begin].group) ++end;
      writeCluster(begin, end);
      for (size_t i = begin; i < end; ++i) clusters_.push_back({begin, end});
      begin = end;
    }
    // Keeps the boxes in the order of the frame.
    for (size_t i = 1; i < boxes_.size(); ++i)
      out_ += fmt::format("  p{} -> p{} [style=invis, weight=8];\n", i - 1, i);
    writeEdges();
    return out_ + "}\n";
  }

 private:
  static bool sameUse(const GraphPass& a, const GraphPass& b) {
    if (a.group != b.group || a.kind != "geometry" || b.kind != "geometry") return false;
    const auto same = [](const auto& left, const auto& right, auto name) {
      return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                        [&](auto& l, auto& r) { return name(l) == name(r); });
    };
    const auto bufferOf = [](const auto& use) { return use.buffer; };
    return same(a.writes, b.writes, bufferOf) && same(a.reads, b.reads, bufferOf) &&
           same(a.images, b.images, [](const GraphImage& image) { return image.name; });
  }

  void place(const GraphPass& pass) {
    for (size_t i = boxes_.size(); i-- > 0 && boxes_[i].group == pass.group;)
      if (sameUse(*boxes_[i].passes[0], pass)) {
        boxes_[i].passes.push_back(&pass);
        boxOf_[pass.name] = i;
        return;
      }
    boxOf_[pass.name] = boxes_.size();
    boxes_.push_back({{&pass}, pass.group});
  }

  std::string title() const {
    std::string text = fmt::format("<B>{}</B>  {}", escape(graph_.pack), escape(graph_.folder));
    if (!graph_.profile.empty()) text += fmt::format("  profile {}", escape(graph_.profile));
    return text;
  }

  void writeCluster(size_t begin, size_t end) {
    out_ +=
        fmt::format("  subgraph cluster_{} {{\n    label=\"{}\";\n", begin, boxes_[begin].group);
    for (size_t i = begin; i < end; ++i)
      out_ += fmt::format("    p{} [label=<{}>];\n", i, boxLabel(boxes_[i]));
    out_ += "  }\n";
  }

  std::string boxLabel(const Box& box) const {
    std::string_view fill = "#ffffff";
    for (const GroupStyle& style : kStyles)
      if (style.group == box.group) fill = style.fill;
    std::string names;
    for (size_t i = 0; i < box.passes.size(); ++i) {
      if (i > 0) names += i % 3 == 0 ? "<BR/>" : ", ";
      names += escape(box.passes[i]->name);
    }
    std::string label = fmt::format(
        "<TABLE BORDER=\"0\" CELLBORDER=\"1\" CELLSPACING=\"0\" CELLPADDING=\"4\" "
        "COLOR=\"#78909c\" "
        "BGCOLOR=\"{}\"><TR><TD><B>{}</B></TD></TR>",
        fill, names);
    const auto row = [&](std::string_view head, const std::string& text) {
      if (!text.empty())
        label += fmt::format("<TR><TD ALIGN=\"LEFT\"><FONT POINT-SIZE=\"8\">{} {}</FONT></TD></TR>",
                             head, text);
    };
    const GraphPass& pass = *box.passes[0];
    row("reads", readText(pass));
    row("draws", writeText(pass));
    row("images", imageText(pass));
    row("textures", escape(fmt::format("{}", fmt::join(pass.textures, ", "))));
    row("groups", groupText(pass));
    return label + "</TABLE>";
  }

  std::string readText(const GraphPass& pass) const {
    std::set<std::string> names, clear;
    for (const GraphRead& read : pass.reads)
      (read.source == GraphRead::Source::Clear ? clear : names).insert(read.buffer);
    std::string text = shortList(names);
    if (!clear.empty())
      text += (text.empty() ? "" : "; ") + shortList(clear) + " (only its clear colour)";
    for (const GraphRead& read : pass.reads)
      if (read.mipmaps) text += "; mipmaps of " + read.buffer;
    return text;
  }

  std::string writeText(const GraphPass& pass) const {
    std::string text;
    for (const GraphWrite& write : pass.writes) {
      const auto buffer = std::find_if(graph_.buffers.begin(), graph_.buffers.end(),
                                       [&](auto& b) { return b.name == write.buffer; });
      if (!text.empty()) text += text.size() - text.rfind('>') > 45 ? "<BR ALIGN=\"LEFT\"/>" : ", ";
      text += write.buffer;
      if (buffer != graph_.buffers.end()) text += " " + buffer->format;
      if (write.alt) text += " alt";
    }
    if (pass.kind == "fullscreen" && (pass.width != graph_.width || pass.height != graph_.height))
      text += fmt::format("; {}x{}", pass.width, pass.height);
    if (pass.scale[0] != 1) text += fmt::format("; scale {:g}", pass.scale[0]);
    return text;
  }

  static std::string imageText(const GraphPass& pass) {
    std::vector<std::string> names;
    for (const GraphImage& image : pass.images)
      names.push_back(escape(image.name) + (image.stores ? " (store)" : ""));
    return fmt::format("{}", fmt::join(names, ", "));
  }

  static std::string groupText(const GraphPass& pass) {
    std::vector<std::string> texts;
    for (const GraphCompute& compute : pass.computes)
      texts.push_back(compute.indirect
                          ? compute.name + ": indirect"
                          : fmt::format("{}: {}x{}x{}", compute.name, compute.groups[0],
                                        compute.groups[1], compute.groups[2]));
    return fmt::format("{}", fmt::join(texts, "<BR ALIGN=\"LEFT\"/>"));
  }

  void writeEdges() {
    for (const GraphPass& pass : graph_.passes) {
      if (pass.kind == "copy") continue;
      for (const GraphRead& read : pass.reads)
        for (const std::string& from : read.from) addEdge(from, pass.name, read);
    }
    for (const auto& [edge, buffers] : edges_) writeEdge(edge, buffers);
  }

  /// Boxes of a geometry group draw one after the other into the same buffers: one edge for them all.
  void addEdge(const std::string& from, const std::string& to, const GraphRead& read) {
    if (!boxOf_.contains(from)) return;
    Edge edge{.from = boxOf_.at(from), .to = boxOf_.at(to)};
    edge.history = read.source == GraphRead::Source::History;
    const auto [begin, end] = clusters_[edge.from];
    const bool geometry = boxes_[edge.from].passes[0]->kind == "geometry";
    if (geometry && end - begin > 1 && (edge.to < begin || edge.to >= end)) {
      edge.from = end - 1;
      edge.wholeGroup = true;
    }
    edges_[edge].insert(read.buffer);
  }

  void writeEdge(const Edge& edge, const std::set<std::string>& buffers) {
    const std::string_view color = edgeColor(*buffers.begin());
    out_ += fmt::format(
        "  p{} -> p{} [label=\"{}\", color=\"{}\", fontcolor=\"{}\"{}{}];\n", edge.from, edge.to,
        shortList(buffers), color, color, edge.history ? ", style=dashed, constraint=false" : "",
        edge.wholeGroup ? fmt::format(", ltail=cluster_{}", clusters_[edge.from].first) : "");
  }

  const PassGraph& graph_;
  std::vector<Box> boxes_;
  std::map<std::string, size_t> boxOf_;
  std::vector<std::pair<size_t, size_t>> clusters_;  ///< by box: first and last+1 of its group
  std::map<Edge, std::set<std::string>> edges_;
  std::string out_;
};

}  // namespace

std::string toDot(const PassGraph& graph) { return DotWriter(graph).write(); }

}  // namespace orris
