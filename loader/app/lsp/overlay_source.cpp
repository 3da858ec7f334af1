#include "app/lsp/overlay_source.h"

#include <algorithm>

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

}  // namespace

std::shared_ptr<const FileSource> overlaidSource(std::shared_ptr<const FileSource> files,
                                                 Overlay overlay) {
  return std::make_shared<OverlaidSource>(std::move(files), std::move(overlay));
}

}  // namespace orris
