#include "core/file_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "core/limits.h"
#include "core/pack_path.h"
#include "core/pack_search.h"
#include "core/read_file.h"
#include "core/read_places.h"
#include "core/zip_source.h"

namespace orris {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBesideShaders = "/../";

class MemorySource : public FileSource {
 public:
  explicit MemorySource(std::map<std::string, std::string> files) {
    for (auto& [path, bytes] : files) {
      if (const auto normal = resolvePackPath("/", path, AboveRoot::Beside)) {
        files_.insert_or_assign(*normal, std::move(bytes));
      }
    }
    for (const auto& entry : files_) {
      if (!isBesideShaders(entry.first)) paths_.push_back(entry.first);
    }
  }
  std::optional<std::string> read(std::string_view path) const override {
    return isBesideShaders(path) ? std::nullopt : MemorySource::readResource(path);
  }
  std::optional<std::string> readResource(std::string_view path) const override {
    const auto found = files_.find(path);
    return found == files_.end() ? std::nullopt : std::optional(found->second);
  }
  const std::vector<std::string>& files() const override { return paths_; }

 private:
  std::map<std::string, std::string, std::less<>> files_;
  std::vector<std::string> paths_;
};

/// A zip, whose files beside `shaders` are read when a texture names one.
class ZipSource : public MemorySource {
 public:
  ZipSource(std::string zip, const PackLimits& limits, std::map<std::string, std::string> files)
      : MemorySource(std::move(files)), zip_(std::move(zip)), limits_(limits) {
    addReadPlace(zip_);
  }
  std::optional<std::string> readResource(std::string_view path) const override {
    return isBesideShaders(path) ? readBesideInZip(zip_, path, limits_)
                                 : MemorySource::readResource(path);
  }

 private:
  std::string zip_;
  PackLimits limits_;
};

class FolderSource : public FileSource {
 public:
  /// `pack` holds `root`; empty when nothing beside `root` is of the pack.
  FolderSource(const fs::path& root, const fs::path& pack, const PackLimits& limits)
      : root_(fs::canonical(root)),
        pack_(pack.empty() ? pack : fs::canonical(pack)),
        limits_(limits) {
    addReadPlace(root_.string());
    addPlacesBeside();
  }

  /// Lists all files; false and a diagnostic when a limit is passed.
  bool scan(Diagnostics& diagnostics) {
    const bool ok = scanFolder("", 0, diagnostics);
    std::sort(paths_.begin(), paths_.end());
    return ok;
  }

  std::optional<std::string> read(std::string_view path) const override {
    if (!contains(path)) return std::nullopt;
    ReadFault ignored{};
    return readFileBelow(root_.string(), std::string(path.substr(1)), limits_.fileBytes, ignored);
  }

  std::optional<std::string> readResource(std::string_view path) const override {
    if (!isBesideShaders(path)) return read(path);
    // Whoever made the path may not have resolved it.
    const auto normal = resolvePackPath("/", path, AboveRoot::Beside);
    if (pack_.empty() || !normal || !isBesideShaders(*normal)) return std::nullopt;
    ReadFault ignored{};
    return readFileBelow(pack_.string(), normal->substr(kBesideShaders.size()), limits_.fileBytes,
                         ignored);
  }

  const std::vector<std::string>& files() const override { return paths_; }

 private:
  /// What textures may name beside `root_`; not what is hidden: a checkout keeps tokens in .git.
  void addPlacesBeside() const {
    std::error_code error;
    if (pack_.empty()) return;
    for (fs::directory_iterator it(pack_, error), end; !error && it != end; it.increment(error)) {
      if (!it->path().filename().string().starts_with('.')) addReadPlace(it->path().string());
    }
  }

  bool scanFolder(const std::string& folder, int depth, Diagnostics& diagnostics) {
    if (depth > limits_.folderDepth)
      return tooLarge(folder, "folders nested deeper than {}", limits_.folderDepth, diagnostics);
    // Two links in each of n folders are walked 2^n times.
    if (++folders_ > limits::kPackFolders)
      return tooLarge(folder, "more than {} folders, counting links", limits::kPackFolders,
                      diagnostics);
    std::error_code error;
    for (fs::directory_iterator
             it(root_ / folder.substr(std::min<size_t>(1, folder.size())), error),
         end;
         !error && it != end; it.increment(error)) {
      if (!scanEntry(folder + "/" + it->path().filename().string(), *it, depth, diagnostics))
        return false;
    }
    if (error) {
      diagnostics.push_back(
          {.severity = Severity::Error,
           .id = "pack-unreadable",
           .at = {.file = folder.empty() ? "/" : folder},
           .message = fmt::format("cannot list the folder: {}", error.message())});
    }
    return !error;
  }

  bool scanEntry(const std::string& path, const fs::directory_entry& entry, int depth,
                 Diagnostics& diagnostics) {
    std::error_code error;
    if (entry.is_symlink(error) && !liesBelow(root_.string(), entry.path().string())) {
      diagnostics.push_back(
          {.severity = Severity::Warning,
           .id = "symlink-outside",
           .at = {.file = path},
           .message = "this symbolic link leads nowhere or out of the pack; it is ignored",
           .hint = "put the file itself into the pack"});
      return true;
    }
    if (entry.is_directory(error)) return scanFolder(path, depth + 1, diagnostics);
    if (!entry.is_regular_file(error)) return true;
    const size_t size = static_cast<size_t>(entry.file_size(error));
    if (size > limits_.fileBytes)
      return tooLarge(path, "a file larger than {} bytes", limits_.fileBytes, diagnostics);
    total_ += size;
    if (total_ > limits_.totalBytes)
      return tooLarge(path, "more than {} bytes of files", limits_.totalBytes, diagnostics);
    paths_.push_back(path);
    return paths_.size() <= limits_.files ||
           tooLarge(path, "more than {} files", limits_.files, diagnostics);
  }

  template <typename Limit>
  static bool tooLarge(const std::string& path, std::string_view what, Limit limit,
                       Diagnostics& diagnostics) {
    diagnostics.push_back({.severity = Severity::Error,
                           .id = "pack-too-large",
                           .at = {.file = path.empty() ? "/" : path},
                           .message = "the pack has " + fmt::format(fmt::runtime(what), limit)});
    return false;
  }

  fs::path root_, pack_;
  PackLimits limits_;
  std::vector<std::string> paths_;
  size_t total_ = 0, folders_ = 0;
};

std::unique_ptr<FileSource> refuse(const std::string& path, std::string message, std::string hint,
                                   Diagnostics& diagnostics) {
  diagnostics.push_back({.severity = Severity::Error,
                         .id = "pack-unreadable",
                         .at = {.file = path},
                         .message = std::move(message),
                         .hint = std::move(hint)});
  return nullptr;
}

constexpr size_t kPacksNamed = 5;

/// The folder is no pack itself; what it holds may be.
std::unique_ptr<FileSource> refuseFolder(const std::string& path, Diagnostics& diagnostics) {
  const std::vector<std::string> packs = findPacks(path);
  if (packs.empty()) {
    return refuse(path, "no shader pack: the folder has no folder named shaders",
                  "give the folder that holds shaders/", diagnostics);
  }
  const size_t named = std::min(packs.size(), kPacksNamed);
  std::string names = fmt::format("{}", fmt::join(packs.begin(), packs.begin() + named, ", "));
  if (named < packs.size()) names += fmt::format(" and {} more", packs.size() - named);
  if (packs.size() == 1) {
    return refuse(path, "no shader pack itself, but it holds one", "give " + names, diagnostics);
  }
  return refuse(path, fmt::format("no shader pack itself, but it holds {}", packs.size()),
                "give one of " + names + "; orris validate --recursive checks all", diagnostics);
}

/// Absent when the folder is no pack.
std::optional<fs::path> rootInside(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder / "shaders", error)) return folder / "shaders";
  fs::path named = folder.has_filename() ? folder : folder.parent_path();
  if (named == "." || named == "..") named = fs::canonical(named, error);
  return named.filename() == "shaders" ? std::optional(folder) : std::nullopt;
}

}  // namespace

bool isBesideShaders(std::string_view path) { return path.starts_with(kBesideShaders); }

std::optional<std::string> FileSource::readResource(std::string_view path) const {
  return isBesideShaders(path) ? std::nullopt : read(path);
}

bool FileSource::contains(std::string_view path) const {
  return std::binary_search(files().begin(), files().end(), path);
}

std::unique_ptr<FileSource> memorySource(std::map<std::string, std::string> files) {
  return std::make_unique<MemorySource>(std::move(files));
}

std::unique_ptr<FileSource> openPack(const std::string& path, Diagnostics& diagnostics,
                                     const PackLimits& limits) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    return refuse(path, "no such shader pack", "give a folder or a .zip", diagnostics);
  }
  if (!fs::is_directory(path, error)) {
    if (!fs::is_regular_file(path, error))
      return refuse(path, "no shader pack: neither a folder nor a file", "give a folder or a .zip",
                    diagnostics);
    auto files = readZip(path, limits, diagnostics);
    return files ? std::make_unique<ZipSource>(path, limits, std::move(*files)) : nullptr;
  }
  const auto root = rootInside(path);
  if (!root) return refuseFolder(path, diagnostics);
  // A path that the user wrote may be a link to anywhere; what a pack brings along may not.
  if (!liesBelow(path, root->string())) {
    return refuse((fs::path(path) / "shaders").string(),
                  "this symbolic link leads out of the pack; it is not followed",
                  "put the folder itself into the pack, or give the folder that it leads to",
                  diagnostics);
  }
  const bool given = fs::equivalent(*root, path, error);
  auto source = std::make_unique<FolderSource>(*root, given ? fs::path() : fs::path(path), limits);
  return source->scan(diagnostics) ? std::move(source) : nullptr;
}

}  // namespace orris
