// The pass graph as tables that read well as plain text too.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include <orris/check/graph/pass_graph.h>

namespace orris {
namespace {

using Row = std::vector<std::string>;

std::string joined(const Row& words) { return fmt::format("{}", fmt::join(words, ", ")); }

/// A cell cannot hold a line break, and '|' would end it.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return out;
}

std::string table(const std::vector<Row>& rows) {
  std::vector<size_t> widths(rows.front().size(), 3);
  for (const Row& row : rows)
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], cell(row[i]).size());
  std::string text;
  const auto line = [&](const Row& row) {
    for (size_t i = 0; i < row.size(); ++i)
      text += fmt::format("{} {:<{}} ", '|', cell(row[i]), widths[i]);
    text += "|\n";
  };
  line(rows.front());
  for (const size_t width : widths) text += fmt::format("| {:-<{}} ", "", width);
  text += "|\n";
  for (size_t i = 1; i < rows.size(); ++i) line(rows[i]);
  return text;
}

std::string sizeOf(int width, int height, const PassGraph& graph) {
  if (width == graph.width && height == graph.height) return "window";
  return fmt::format("{}x{}", width, height);
}

std::string clearOf(const GraphBuffer& buffer) {
  if (!buffer.clear) return "kept";
  if (buffer.clearToFog) return "fog colour";
  const auto& c = buffer.clearColor;
  return fmt::format("{:g} {:g} {:g} {:g}", c[0], c[1], c[2], c[3]);
}

std::string buffersTable(const PassGraph& graph) {
  std::map<std::string, Row> writers, readers;
  const auto add = [](Row& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const GraphPass& pass : graph.passes) {
    for (const GraphWrite& write : pass.writes) add(writers[write.buffer], pass.title);
    for (const GraphImage& image : pass.images)
      if (image.stores) add(writers[image.buffer], pass.title);
    for (const GraphRead& read : pass.reads) add(readers[read.buffer], pass.title);
  }
  std::vector<Row> rows{{"buffer", "format", "size", "cleared to", "drawn by", "read by"}};
  for (const GraphBuffer& buffer : graph.buffers)
    rows.push_back({buffer.name, buffer.format, sizeOf(buffer.width, buffer.height, graph),
                    clearOf(buffer), joined(writers[buffer.name]), joined(readers[buffer.name])});
  return rows.size() == 1 ? "None.\n" : table(rows);
}

std::string readOf(const GraphRead& read) {
  std::string text = read.buffer;
  if (read.source == GraphRead::Source::History) text += " (last frame)";
  if (read.source == GraphRead::Source::Clear) text += " (clear colour)";
  if (read.mipmaps) text += " (mipmaps)";
  return text;
}

std::string notesOf(const GraphPass& pass, const PassGraph& graph) {
  Row notes;
  if (!pass.drawn) notes.push_back("drawn where a world has it");
  if (pass.file.empty() && pass.kind != "copy") notes.push_back("built in");
  for (const GraphCompute& compute : pass.computes)
    notes.push_back(compute.indirect ? fmt::format("{}: indirect", compute.name)
                                     : fmt::format("{}: {}x{}x{} groups of {}x{}x{}", compute.name,
                                                   compute.groups[0], compute.groups[1],
                                                   compute.groups[2], compute.localSize[0],
                                                   compute.localSize[1], compute.localSize[2]));
  if (pass.kind == "fullscreen" && (pass.width != graph.width || pass.height != graph.height))
    notes.push_back(fmt::format("{}x{}", pass.width, pass.height));
  if (pass.scale[0] != 1) notes.push_back(fmt::format("scale {:g}", pass.scale[0]));
  for (const std::string& texture : pass.textures) notes.push_back("texture " + texture);
  return joined(notes);
}

std::string programsTable(const PassGraph& graph) {
  std::vector<Row> rows{{"#", "program", "reads", "draws to", "images", "flips", "notes"}};
  for (const GraphPass& pass : graph.passes) {
    Row reads, writes, images;
    for (const GraphRead& read : pass.reads) reads.push_back(readOf(read));
    for (const GraphWrite& write : pass.writes)
      writes.push_back(write.buffer + (write.alt ? " alt" : ""));
    for (const GraphImage& image : pass.images)
      images.push_back(fmt::format("{} ({})", image.name,
                                   image.loads && image.stores ? "load, store"
                                   : image.stores              ? "store"
                                                               : "load"));
    rows.push_back({std::to_string(rows.size()), pass.name, joined(reads), joined(writes),
                    joined(images), joined(pass.flips), notesOf(pass, graph)});
  }
  return table(rows);
}

std::string imagesTable(const PassGraph& graph) {
  std::vector<Row> rows{{"image", "sampler", "format", "size", "cleared each frame"}};
  for (const CustomImage& image : graph.images) {
    std::string size = fmt::format("{:g}", image.size[0]);
    for (int i = 1; i < image.dimensions; ++i)
      size += fmt::format(" x {:g}", image.size[static_cast<size_t>(i)]);
    rows.push_back({image.name, image.sampler, image.internalFormat,
                    image.relative ? size + " of the window" : size, image.clear ? "yes" : "no"});
  }
  return table(rows);
}

}  // namespace

std::string toMarkdown(const PassGraph& graph) {
  std::string text = fmt::format("# {}, {}\n\n", cell(graph.pack), graph.folder);
  if (!graph.profile.empty()) text += fmt::format("Profile {}. ", cell(graph.profile));
  text += fmt::format("Window {}x{}.\n\n## Buffers\n\n{}\n## Programs\n\n{}", graph.width,
                      graph.height, buffersTable(graph), programsTable(graph));
  if (!graph.images.empty()) text += fmt::format("\n## Images\n\n{}", imagesTable(graph));
  if (!graph.disabled.empty())
    text += fmt::format("\nSwitched off: {}.\n", cell(joined(graph.disabled)));
  return text;
}

}  // namespace orris
