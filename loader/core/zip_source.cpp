#include "core/zip_source.h"

#include <fmt/format.h>
#include <zip.h>

#include <memory>
#include <mutex>

#include "core/add_diagnostic.h"
#include "core/pack_path.h"
#include "core/read_places.h"

namespace orris {
namespace {

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using Entry = std::unique_ptr<zip_file_t, decltype(&zip_fclose)>;

constexpr const char* kDamagedHint = "the archive is damaged or cut off; fetch or zip it again";

constexpr const char* kTwiceHint = "which one counts is up to the reader: zip the folder again";

Archive openArchive(const std::string& path, Diagnostics& diagnostics) {
  int code = 0;
  Archive archive(zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code), zip_discard);
  if (!archive) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    const bool twice = code == ZIP_ER_EXISTS;
    addError(diagnostics, "zip-unreadable", {path},
             twice ? "two files in the zip have the same name"
                   : fmt::format("cannot read the zip: {}", zip_error_strerror(&error)),
             twice                                           ? kTwiceHint
             : code == ZIP_ER_NOZIP || code == ZIP_ER_INCONS ? kDamagedHint
                                                             : "");
    zip_error_fini(&error);
  }
  return archive;
}

/// `folder` at the top wins over the first one found deeper. nullopt: there is none.
std::optional<std::string> findRoot(zip_t* archive, zip_int64_t count,
                                    const std::string& folder = "/shaders") {
  const std::string inside = folder + "/";
  std::optional<std::string> deeper;
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive, static_cast<zip_uint64_t>(i), 0);
    if (!name) continue;
    const std::string path = std::string("/") + name;
    if (!resolvePackPath("/", path)) continue;
    const size_t at = path.find(inside);
    if (at == 0) return folder;
    if (at != std::string::npos && !deeper) deeper = path.substr(0, at) + folder;
  }
  return deeper;
}

struct EntryText {
  std::optional<std::string> bytes;
  std::string problem, hint;  ///< unless bytes
};

/// Why libzip cannot read an entry, in the words of who made it.
EntryText refusal(zip_t* archive, zip_uint64_t index) {
  zip_stat_t stat;
  const bool known = zip_stat_index(archive, index, 0, &stat) == 0;
  if (known && (stat.valid & ZIP_STAT_ENCRYPTION_METHOD) && stat.encryption_method != ZIP_EM_NONE)
    return {std::nullopt, "is encrypted", "zip it without a password"};
  const bool method = known && (stat.valid & ZIP_STAT_COMP_METHOD);
  // Minecraft is written in Java, whose archives know these two.
  if (method && stat.comp_method != ZIP_CM_STORE && stat.comp_method != ZIP_CM_DEFLATE)
    return {std::nullopt, fmt::format("is compressed by method {}", stat.comp_method),
            "zip it with deflate, which the game reads, too"};
  return {std::nullopt, "cannot be read", kDamagedHint};
}

EntryText readEntry(zip_t* archive, zip_uint64_t index, size_t limit) {
  EntryText refused = refusal(archive, index);
  if (refused.hint != kDamagedHint) return refused;
  const Entry entry(zip_fopen_index(archive, index, 0), zip_fclose);
  if (!entry) return refused;
  std::string bytes;
  char block[1 << 16];
  zip_int64_t got = 0;
  while ((got = zip_fread(entry.get(), block, sizeof block)) > 0) {
    bytes.append(block, static_cast<size_t>(got));
    // The size written in the archive may be a lie.
    if (bytes.size() > limit)
      return {std::nullopt, fmt::format("is larger than {} bytes", limit), "leave it out"};
  }
  return got < 0 ? refused : EntryText{std::move(bytes), "", ""};
}

/// The archive stays open; its entries are read when they are asked for.
class LazyZip : public FileSource {
 public:
  LazyZip(Archive archive, const PackLimits& limits)
      : archive_(std::move(archive)), limits_(limits) {}

  /// Names that leave the archive are left out; of two with one name the first counts.
  void list(const std::string& root) {
    const std::string inside = root + "/";
    const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
    for (zip_int64_t i = 0; i < count; ++i) {
      const char* name = zip_get_name(archive_.get(), static_cast<zip_uint64_t>(i), 0);
      if (!name || std::string_view(name).ends_with('/')) continue;
      const auto path = resolvePackPath("/", std::string("/") + name);
      if (!path || !path->starts_with(inside)) continue;
      index_.emplace(path->substr(root.size()), static_cast<zip_uint64_t>(i));
    }
    for (const auto& entry : index_) paths_.push_back(entry.first);
  }

  std::optional<std::string> read(std::string_view path) const override {
    const std::lock_guard lock(mutex_);
    const auto found = index_.find(path);
    if (found == index_.end() || total_ > limits_.totalBytes) return std::nullopt;
    auto bytes = readEntry(archive_.get(), found->second, limits_.fileBytes).bytes;
    total_ += bytes ? bytes->size() : limits_.fileBytes;
    return bytes;
  }
  const std::vector<std::string>& files() const override { return paths_; }

 private:
  Archive archive_;
  PackLimits limits_;
  std::map<std::string, zip_uint64_t, std::less<>> index_;
  std::vector<std::string> paths_;
  mutable std::mutex mutex_;       // of libzip's place in the file
  mutable std::size_t total_ = 0;  // bytes read so far
};

}  // namespace

std::unique_ptr<FileSource> openZipBelow(const std::string& path, const std::string& folder,
                                         const PackLimits& limits, Diagnostics& diagnostics) {
  Archive archive = openArchive(path, diagnostics);
  if (!archive) return nullptr;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  if (count > static_cast<zip_int64_t>(limits.files)) {
    addError(diagnostics, "pack-too-large", {path},
             fmt::format("the zip has more than {} files", limits.files));
    return nullptr;
  }
  const auto root = findRoot(archive.get(), count, folder);
  if (!root) return memorySource({});
  addReadPlace(path);
  auto source = std::make_unique<LazyZip>(std::move(archive), limits);
  source->list(*root);
  return source;
}

std::optional<std::string> readBesideInZip(const std::string& zip, std::string_view path,
                                           const PackLimits& limits) {
  Diagnostics ignored;  // reported when the pack was opened
  const Archive archive = openArchive(zip, ignored);
  if (!archive) return std::nullopt;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  const auto root = findRoot(archive.get(), count);
  const auto wanted = root ? resolvePackPath(*root + "/", path.substr(1)) : std::nullopt;
  for (zip_int64_t i = 0; wanted && i < count; ++i) {
    const char* name = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0);
    if (name && resolvePackPath("/", std::string("/") + name) == wanted)
      return readEntry(archive.get(), static_cast<zip_uint64_t>(i), limits.fileBytes).bytes;
  }
  return std::nullopt;
}

std::optional<std::map<std::string, std::string>> readZip(const std::string& path,
                                                          const PackLimits& limits,
                                                          Diagnostics& diagnostics) {
  const Archive archive = openArchive(path, diagnostics);
  if (!archive) return std::nullopt;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  const auto root = findRoot(archive.get(), count);
  if (!root) {
    addError(diagnostics, "pack-unreadable", {path},
             "no shader pack: the zip has no folder named shaders",
             "zip the folder that holds shaders/");
    return std::nullopt;
  }
  std::map<std::string, std::string> files;
  size_t total = 0;
  for (zip_int64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive.get(), static_cast<zip_uint64_t>(i), 0);
    const auto inside = name ? resolvePackPath("/", std::string("/") + name) : std::nullopt;
    if (!inside || !inside->starts_with(*root + "/") || std::string_view(name).ends_with('/'))
      continue;
    EntryText entry = readEntry(archive.get(), static_cast<zip_uint64_t>(i), limits.fileBytes);
    if (!entry.bytes) {
      addError(diagnostics, "zip-unreadable", {path},
               fmt::format("{} in the zip {}", *inside, entry.problem), std::move(entry.hint));
      return std::nullopt;
    }
    total += entry.bytes->size();
    if (total > limits.totalBytes || files.size() >= limits.files) {
      addError(diagnostics, "pack-too-large", {path},
               fmt::format("the pack has more than {} bytes or {} files", limits.totalBytes,
                           limits.files));
      return std::nullopt;
    }
    if (!files.emplace(inside->substr(root->size()), std::move(*entry.bytes)).second) {
      addError(diagnostics, "zip-unreadable", {path},
               fmt::format("{} is twice in the zip", *inside), kTwiceHint);
      return std::nullopt;
    }
  }
  return files;
}

bool isPackZip(const std::string& path) {
  Diagnostics ignored;
  const Archive archive = openArchive(path, ignored);
  return archive && findRoot(archive.get(), zip_get_num_entries(archive.get(), 0));
}

}  // namespace orris
