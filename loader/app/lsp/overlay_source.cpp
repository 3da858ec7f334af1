#include "app/lsp/overlay_source.h"

#include <algorithm>

#include <orris/pack/files/include_graph.h>
#include <orris/pack/programs/program_id.h>

namespace orris {
namespace {

class OverlaidSource final : public FileSource {
 public:
  OverlaidSource(std::shared_ptr<const FileSource> files, Overlay overlay)
      : below_(std::move(files)), overlay_(std::move(overlay)), files_(below_->files()) {
    for (const auto& [path, text] : overlay_) files_.push_back(path);
    std::ranges::sort(files_);
    files_.erase(std::ranges::unique(files_).begin(), files_.end());
  }
  std::optional<std::string> read(std::string_view path) const override {
    const auto found = overlay_.find(std::string(path));
    return found == overlay_.end() ? below_->read(path) : found->second;
  }
  const std::vector<std::string>& files() const override { return files_; }
  std::optional<std::string> readResource(std::string_view path) const override {
    return isBesideShaders(path) ? below_->readResource(path) : read(path);
  }

 private:
  std::shared_ptr<const FileSource> below_;
  Overlay overlay_;
  std::vector<std::string> files_;
};

class FewerStages final : public FileSource {
 public:
  FewerStages(std::shared_ptr<const FileSource> files, const std::set<std::string>& kept)
      : below_(std::move(files)) {
    for (const std::string& path : below_->files())
      if (kept.contains(path) || !parseProgramFile(path)) files_.push_back(path);
  }
  std::optional<std::string> read(std::string_view path) const override {
    const bool here = std::ranges::binary_search(files_, path);
    return here ? below_->read(path) : std::nullopt;
  }
  const std::vector<std::string>& files() const override { return files_; }
  std::optional<std::string> readResource(std::string_view path) const override {
    return below_->readResource(path);
  }

 private:
  std::shared_ptr<const FileSource> below_;
  std::vector<std::string> files_;
};

}  // namespace

std::shared_ptr<const FileSource> overlaidSource(std::shared_ptr<const FileSource> files,
                                                 Overlay overlay) {
  return std::make_shared<OverlaidSource>(std::move(files), std::move(overlay));
}

std::shared_ptr<const FileSource> onlyStages(std::shared_ptr<const FileSource> files,
                                             const std::set<std::string>& kept) {
  return std::make_shared<FewerStages>(std::move(files), kept);
}

std::set<std::string> affectedStages(const FileSource& files, const std::set<std::string>& changed) {
  std::vector<std::string> entries;
  for (const std::string& path : files.files())
    if (parseProgramFile(path)) entries.push_back(path);
  Diagnostics ignored;
  const IncludeGraph graph = readIncludeGraph(files, entries, ignored);
  std::set<std::pair<std::string, std::string>> programs;
  for (const std::string& entry : entries) {
    const std::vector<std::string> reached = reachableFiles(graph, entry);
    const bool reads = std::ranges::any_of(
        reached, [&](const std::string& file) { return changed.contains(file); });
    if (!reads) continue;
    const auto file = parseProgramFile(entry);
    programs.insert({file->folder, file->program});
  }
  std::set<std::string> stages;
  for (const std::string& entry : entries) {
    const auto file = parseProgramFile(entry);
    if (programs.contains({file->folder, file->program})) stages.insert(entry);
  }
  return stages;
}

}  // namespace orris
