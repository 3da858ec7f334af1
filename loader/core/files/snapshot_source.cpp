#include <orris/core/files/snapshot_source.h>

#include <algorithm>
#include <atomic>

#include <orris/core/limits.h>

namespace orris {
namespace {

class SnapshotSource final : public FileSource {
 public:
  explicit SnapshotSource(std::shared_ptr<const FileSource> source)
      : source_(std::move(source)), kept_(source_->files().size()) {}
  ~SnapshotSource() override {
    for (const auto& bytes : kept_) delete bytes.load();
  }
  SnapshotSource(const SnapshotSource&) = delete;
  SnapshotSource& operator=(const SnapshotSource&) = delete;

  std::optional<std::string> read(std::string_view path) const override {
    const auto found = std::lower_bound(files().begin(), files().end(), path);
    if (found == files().end() || *found != path) return std::nullopt;
    std::atomic<const std::string*>& kept = kept_[static_cast<std::size_t>(found - files().begin())];
    if (const std::string* bytes = kept.load()) return *bytes;
    auto bytes = source_->read(path);
    if (bytes && bytes->size() <= limits::kSnapshotBytes - std::min(total_.load(), limits::kSnapshotBytes))
      return keep(std::move(*bytes), kept);
    return bytes;
  }
  std::optional<std::string> readResource(std::string_view path) const override {
    return isBesideShaders(path) ? source_->readResource(path) : read(path);
  }
  const std::vector<std::string>& files() const override { return source_->files(); }

 private:
  /// What is kept: these bytes, or those of a thread that was sooner. A lock would be held for ever in a process that is
  /// forked meanwhile.
  const std::string& keep(std::string bytes, std::atomic<const std::string*>& kept) const {
    auto own = std::make_unique<const std::string>(std::move(bytes));
    const std::string* sooner = nullptr;
    if (!kept.compare_exchange_strong(sooner, own.get())) return *sooner;
    total_ += own->size();
    return *own.release();
  }

  std::shared_ptr<const FileSource> source_;
  mutable std::vector<std::atomic<const std::string*>> kept_;
  mutable std::atomic<std::size_t> total_{0};
};

}  // namespace

std::shared_ptr<const FileSource> snapshotOf(std::shared_ptr<const FileSource> source) {
  return std::make_shared<SnapshotSource>(std::move(source));
}

}  // namespace orris
