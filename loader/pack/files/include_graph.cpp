#include <orris/pack/files/include_graph.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include <orris/core/limits.h>
#include <orris/core/message_limits.h>
#include <orris/core/files/pack_path.h>
#include <orris/core/files/text_file.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

constexpr std::string_view kInclude = "#include";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Walks depth first, so that the open files are the chain of includes.
class Reader {
 public:
  Reader(const FileSource& source, Diagnostics& diagnostics, IncludeGraph& graph)
      : source_(source), diagnostics_(diagnostics), graph_(graph) {}

  /// `path` is known to exist.
  void visit(const std::string& path) {
    const FileLines& lines = graph_.files[path] = splitLines(readText(path));
    if (!lines.empty() && lines.front().starts_with(kByteOrderMark)) reportByteOrderMark(path);
    for (size_t i = 0; i < lines.size(); ++i) {
      const std::string_view line = trim(lines[i]);
      if (line.starts_with(kInclude)) include(path, static_cast<int>(i) + 1, lines[i]);
    }
  }

 private:
  struct Open {
    std::string file;
    int line;
  };

  /// "" for a file that is refused, which counts as a broken include of its first line.
  std::string readText(const std::string& path) {
    TextFile text = readTextFile(source_, path);
    bytes_ += text.bytes.size();
    if (text.ok && bytes_ > limits::kPackTextBytes) {
      text = {.problem = packTextTooLarge(path)};
    }
    if (text.ok) return std::move(text.bytes);
    graph_.includes[path][1] = "";
    for (size_t i = open_.size(); i-- > 0;)
      text.problem.includedFrom.push_back({.file = open_[i].file, .line = open_[i].line});
    diagnostics_.push_back(std::move(text.problem));
    return "";
  }

  // The preprocessor throws. Iris: JcppProcessor.
  void reportByteOrderMark(const std::string& path) {
    Diagnostic diagnostic{
        .severity = Severity::Error,
        .id = "byte-order-mark",
        .at = {path, 1, 1},
        .message = "the file begins with a byte-order mark",
        .hint = "save it as UTF-8 without one (\"UTF-8\", not \"UTF-8 with BOM\")"};
    for (auto open = open_.rbegin(); open != open_.rend(); ++open)
      diagnostic.includedFrom.push_back({.file = open->file, .line = open->line});
    diagnostics_.push_back(withEffect(std::move(diagnostic), Effect::RefusesPack));
  }

  void include(const std::string& from, int line, const std::string& text) {
    open_.push_back({from, line});
    const auto target = resolve(from, text);
    const bool good = target && mayOpen(*target, text);
    graph_.includes[from][line] = good ? *target : "";
    if (good && !graph_.files.contains(*target)) visit(*target);
    open_.pop_back();
  }

  /// False when reported as an error.
  bool mayOpen(const std::string& target, const std::string& text) {
    const bool isOpen =
        std::any_of(open_.begin(), open_.end(), [&](const Open& o) { return o.file == target; });
    if (isOpen) {
      reportCycle(target, text);
      return false;
    }
    if (graph_.files.contains(target) || open_.size() <= limits::kIncludeDepth) return true;
    report("include-too-deep", text,
           fmt::format("includes are nested deeper than {} files", limits::kIncludeDepth), "");
    return false;
  }

  /// The file that the line names; nullopt when reported as an error.
  std::optional<std::string> resolve(const std::string& from, const std::string& text) {
    std::string_view written = trim(trim(text).substr(kInclude.size()));
    if (written.starts_with('"')) written.remove_prefix(1);
    const size_t quote = written.find('"');
    if (written.empty() || (quote != std::string_view::npos && quote + 1 != written.size()))
      return malformed(from, text, written.substr(0, quote), trim(written.substr(std::min(quote, written.size()))));
    written = written.substr(0, quote);
    const auto target = resolvePackPath(from, written, AboveRoot::Stay);
    const bool leavesRoot = !resolvePackPath(from, written);
    if (leavesRoot) {
      // Iris stays at the root, so that such a path may still name a file.
      const bool works = target && source_.contains(*target);
      report("include-escape", text, fmt::format("\"{}\" leads out of the shaders folder", written),
             works ? fmt::format("Iris takes it for {}, other hosts refuse it", *target)
                   : escapeHint(written),
             works ? Severity::Warning : Severity::Error);
      if (works) return target;
      const std::string inside = pathInside(written);
      return inside.empty() ? std::nullopt : readAllTheSame(inside, inside);
    }
    return source_.contains(*target) ? target : missing(*target, text);
  }

  /// "/../shaders/lib/a.glsl" is meant to be "/lib/a.glsl"; "" for a file that is not there.
  std::string pathInside(std::string_view written) const {
    constexpr std::string_view kShaders = "/shaders/";
    const size_t at = written.rfind(kShaders);
    const std::string inside =
        at == written.npos ? "" : std::string(written.substr(at + kShaders.size() - 1));
    return !inside.empty() && source_.contains(inside) ? inside : "";
  }

  std::string escapeHint(std::string_view written) const {
    const std::string inside = pathInside(written);
    return inside.empty() ? "paths start at shaders/ with / or at the folder of this file"
                          : fmt::format("write \"{}\"", inside);
  }

  /// The last report would be gone with this path.
  void propose(const std::string& path) {
    diagnostics_.back().repair = LineEdit{open_.back().file, open_.back().line,
                                          fmt::format("#include \"{}\"", path), true};
  }

  static std::string_view fileName(std::string_view path) {
    return path.substr(path.rfind('/') + 1);
  }
  /// Paths of one folder are much alike: the names of the files must be as well.
  static bool isLike(std::string_view a, std::string_view b) {
    return editDistance(lowerCase(a), lowerCase(b)) <= a.size() / 3 + 1;
  }

  std::optional<std::string> missing(const std::string& target, const std::string& text) {
    std::string nearest =
        hints_++ < limits::kSuggestions ? nearestName(target, source_.files()) : "";
    if (!isLike(fileName(target), fileName(nearest))) nearest.clear();
    const bool capitals = lowerCase(nearest) == lowerCase(target);
    report(capitals ? "include-capitals" : "include-missing", text,
           fmt::format("no such file: {}", target),
           nearest.empty() ? "a missing #include refuses the whole pack, even in an inactive branch"
                           : fmt::format("did you mean {}?{}", nearest,
                                         capitals ? " Capitals count in a zip and on Linux" : ""));
    if (capitals) return readAllTheSame(nearest, nearest);
    if (!nearest.empty()) propose(nearest);
    return std::nullopt;
  }

  /// `rest` begins with the closing quote. Of a path before a comment it is plain what is meant.
  std::optional<std::string> malformed(const std::string& from, const std::string& text,
                                       std::string_view path, std::string_view rest) {
    report("include-syntax", text, "expected one path in quotes and nothing after it",
           "write #include \"/lib/name.glsl\", the comment on its own line");
    rest = trim(rest.substr(std::min<size_t>(1, rest.size())));
    if (!rest.starts_with("//") && !rest.starts_with("/*")) return std::nullopt;
    const auto target = resolvePackPath(from, path);
    return target && source_.contains(*target) ? readAllTheSame(*target, std::string(path))
                                               : std::nullopt;
  }

  /// The error stands; with the file in place what else is wrong is found, too.
  std::optional<std::string> readAllTheSame(const std::string& target, const std::string& written) {
    propose(written);
    graph_.misnaming.insert(open_.back().file);
    return target;
  }

  void reportCycle(const std::string& target, const std::string& text) {
    std::string cycle;
    const auto first =
        std::find_if(open_.begin(), open_.end(), [&](const Open& o) { return o.file == target; });
    for (auto it = first; it != open_.end(); ++it) cycle += it->file + " -> ";
    report("include-cycle", text, "include cycle: " + cycle + target,
           "include guards do not help: includes are expanded before any #ifdef");
  }

  void report(std::string id, const std::string& text, std::string message, std::string hint,
              Severity severity = Severity::Error) {
    const Open& here = open_.back();
    Diagnostic diagnostic{.severity = severity,
                          .id = std::move(id),
                          .at = {here.file, here.line, static_cast<int>(text.find('#')) + 1},
                          .message = std::move(message),
                          .sourceLine = quotedLine(text, 0),
                          .hint = std::move(hint)};
    for (size_t i = open_.size() - 1; i-- > 0;) {
      diagnostic.includedFrom.push_back({.file = open_[i].file, .line = open_[i].line});
    }
    diagnostics_.push_back(std::move(diagnostic));
  }

  const FileSource& source_;
  Diagnostics& diagnostics_;
  IncludeGraph& graph_;
  std::vector<Open> open_;
  size_t bytes_ = 0;
  size_t hints_ = 0;
};

class Flattener {
 public:
  Flattener(const IncludeGraph& graph, const FileLookup& files, FlatSource& flat)
      : graph_(graph), files_(files), flat_(flat) {}

  /// False when the result is too large.
  bool expand(const std::string& path, int parent, int parentLine) {
    const int site = static_cast<int>(flat_.sites.size());
    flat_.sites.push_back({path, parent, parentLine});
    const FileLines* lines = files_(path);
    if (!lines) return true;
    const auto includes = graph_.includes.find(path);
    for (size_t i = 0; i < lines->size(); ++i) {
      const int line = static_cast<int>(i) + 1;
      if (includes != graph_.includes.end()) {
        if (const auto target = includes->second.find(line); target != includes->second.end()) {
          if (!target->second.empty() && !expand(target->second, site, line)) return false;
          continue;
        }
      }
      bytes_ += (*lines)[i].size();
      if (flat_.lines.size() >= limits::kStageLines || bytes_ > limits::kStageBytes)
        return refuse(site, line);
      flat_.lines.push_back({(*lines)[i], site, line});
    }
    // Empty files can still be included without end.
    return flat_.sites.size() < limits::kStageFiles || refuse(site, 0);
  }

  /// Where the limit was met.
  const Origin& refusedAt() const { return refusedAt_; }

 private:
  bool refuse(int site, int line) {
    refusedAt_ = {site, line, 0};
    return false;
  }

  const IncludeGraph& graph_;
  const FileLookup& files_;
  FlatSource& flat_;
  Origin refusedAt_;
  size_t bytes_ = 0;
};

}  // namespace

IncludeGraph readIncludeGraph(const FileSource& source, const std::vector<std::string>& entries,
                              Diagnostics& diagnostics) {
  IncludeGraph graph;
  Reader reader(source, diagnostics, graph);
  for (const std::string& entry : entries) {
    if (!graph.files.contains(entry)) reader.visit(entry);
  }
  return graph;
}

FlatSource flatten(const IncludeGraph& graph, const FileLookup& files, const std::string& entry,
                   Diagnostics& diagnostics) {
  FlatSource flat;
  Flattener flattener(graph, files, flat);
  if (!flattener.expand(entry, -1, 0)) {
    const Origin& at = flattener.refusedAt();
    diagnostics.push_back(
        {.severity = Severity::Error,
         .id = "source-too-large",
         .at = locate(flat.sites, at),
         .message =
             fmt::format("with its includes, {} has more than {} lines, {} bytes or {} files here",
                         entry, limits::kStageLines, limits::kStageBytes, limits::kStageFiles),
         .includedFrom = includedFrom(flat.sites, at.site),
         .hint = "include less, or each file once"});
    flat.lines.clear();
  }
  return flat;
}

std::vector<std::string> reachableFiles(const IncludeGraph& graph, const std::string& entry) {
  std::set<std::string> seen{entry};
  std::vector<std::string> open{entry};
  while (!open.empty()) {
    const auto includes = graph.includes.find(open.back());
    open.pop_back();
    if (includes == graph.includes.end()) continue;
    for (const auto& [line, target] : includes->second) {
      if (!target.empty() && seen.insert(target).second) open.push_back(target);
    }
  }
  return {seen.begin(), seen.end()};
}

}  // namespace orris
