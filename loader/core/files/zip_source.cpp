#include <orris/core/files/zip_source.h>

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>

#include <orris/core/add_diagnostic.h>
#include <orris/core/files/pack_path.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/read_places.h>

namespace orris {
namespace {

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using Entry = std::unique_ptr<zip_file_t, decltype(&zip_fclose)>;

constexpr const char* kDamagedHint = "the archive is damaged or cut off; fetch or zip it again";

constexpr const char* kTwiceHint = "which one counts is up to the reader: zip the folder again";

void failToOpen(const std::string& path, zip_error_t& error, Diagnostics& diagnostics) {
  const int code = zip_error_code_zip(&error);
  const bool twice = code == ZIP_ER_EXISTS;
  addError(diagnostics, "zip-unreadable", {path},
       twice ? "two files in the zip have the same name"
             : fmt::format("cannot read the zip: {}", zip_error_strerror(&error)),
       twice                                           ? kTwiceHint
       : code == ZIP_ER_NOZIP || code == ZIP_ER_INCONS ? kDamagedHint
                                                       : "");
}

Archive openArchive(const std::string& path, Diagnostics& diagnostics) {
  int code = 0;
  Archive archive(zip_open(path.c_str(), ZIP_RDONLY | ZIP_CHECKCONS, &code), zip_discard);
  if (!archive) {
    zip_error_t error;
    zip_error_init_with_code(&error, code);
    failToOpen(path, error, diagnostics);
    zip_error_fini(&error);
  }
  return archive;
}

/// `bytes`, those of the file `path`, must outlive the archive.
Archive openArchive(const std::string& path, const std::string& bytes, Diagnostics& diagnostics) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = nullptr;
  // libzip takes no bytes at all for an archive that is to be made.
  if (bytes.empty()) {
    zip_error_set(&error, ZIP_ER_NOZIP, 0);
  } else {
    source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  }
  Archive archive(
      source ? zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error) : nullptr,
      zip_discard);
  if (!archive) {
    failToOpen(path, error, diagnostics);
    if (source) zip_source_free(source);
  }
  zip_error_fini(&error);
  return archive;
}

struct ZipEntry {
  std::string path;  ///< "/MyPack/shaders/final.fsh"
  zip_uint64_t index = 0;
  bool folder = false;
  std::uint64_t size = 0;  ///< as the archive says; 0 where it does not
};

/// In the order of the archive. Names that leave it are left out.
std::vector<ZipEntry> listEntries(zip_t* archive) {
  std::vector<ZipEntry> entries;
  const auto count = static_cast<zip_uint64_t>(zip_get_num_entries(archive, 0));
  for (zip_uint64_t i = 0; i < count; ++i) {
    const char* name = zip_get_name(archive, i, 0);
    auto path = name ? resolvePackPath("/", std::string("/") + name) : std::nullopt;
    if (!path) continue;
    zip_stat_t stat;
    const bool sized = zip_stat_index(archive, i, 0, &stat) == 0 && (stat.valid & ZIP_STAT_SIZE);
    const bool folder = std::string_view(name).ends_with('/');
    entries.push_back({std::move(*path) + (folder ? "/" : ""), i, folder, sized ? stat.size : 0});
  }
  return entries;
}

/// `folder` at the top wins over the first one found deeper. nullopt: there is none.
std::optional<std::string> findRoot(const std::vector<ZipEntry>& entries,
                                    const std::string& folder = "/shaders") {
  const std::string inside = folder + "/";
  std::optional<std::string> deeper;
  for (const ZipEntry& entry : entries) {
    const size_t at = entry.path.find(inside);
    if (at == 0) return folder;
    if (at != std::string::npos && !deeper) deeper = entry.path.substr(0, at) + folder;
  }
  return deeper;
}

bool tooManyFiles(zip_t* archive, const std::string& zip, const PackLimits& limits,
                  Diagnostics& diagnostics) {
  if (zip_get_num_entries(archive, 0) <= static_cast<zip_int64_t>(limits.files)) return false;
  addError(diagnostics, "pack-too-large", {zip},
           fmt::format("the zip has more than {} files", limits.files));
  return true;
}

struct EntryText {
  std::optional<std::string> bytes;
  std::string problem, hint;  ///< unless bytes
  size_t size = 0;            ///< of what was read
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

/// Up to `limit` bytes; without `keep` all are read to see whether they can be, and `bytes` is empty.
EntryText readEntry(zip_t* archive, zip_uint64_t index, size_t limit, bool keep = true) {
  EntryText refused = refusal(archive, index);
  if (refused.hint != kDamagedHint) return refused;
  const Entry entry(zip_fopen_index(archive, index, 0), zip_fclose);
  if (!entry) return refused;
  std::string bytes;
  char block[1 << 16];
  size_t size = 0;
  zip_int64_t got = 0;
  while ((got = zip_fread(entry.get(), block, sizeof block)) > 0) {
    size += static_cast<size_t>(got);
    // The size written in the archive may be a lie.
    if (size > limit)
      return {std::nullopt, fmt::format("is larger than {} bytes", limit), "leave it out"};
    if (keep) bytes.append(block, static_cast<size_t>(got));
  }
  return got < 0 ? refused : EntryText{std::move(bytes), "", "", size};
}

/// The archive stays open; its entries are read when they are asked for.
class LazyZip : public FileSource {
 public:
  /// Of two entries with one name the first counts.
  LazyZip(Archive archive, const std::vector<ZipEntry>& entries, std::string root,
          const PackLimits& limits)
      : archive_(std::move(archive)), root_(std::move(root)), limits_(limits) {
    for (const ZipEntry& entry : entries) {
      if (!entry.folder) index_.emplace(entry.path, entry.index);
    }
    for (const auto& [path, index] : index_) {
      if (path.starts_with(root_ + "/")) paths_.push_back(path.substr(root_.size()));
    }
  }

  std::optional<std::string> read(std::string_view path) const override {
    const std::lock_guard lock(mutex_);
    if (total_ > limits_.totalBytes) return std::nullopt;
    auto bytes = readWhole(root_ + std::string(path));
    total_ += bytes ? bytes->size() : limits_.fileBytes;
    return bytes;
  }
  const std::vector<std::string>& files() const override { return paths_; }

 protected:
  std::optional<std::string> readWhole(const std::string& inside) const {
    const auto found = index_.find(inside);
    if (found == index_.end()) return std::nullopt;
    return readEntry(archive_.get(), found->second, limits_.fileBytes).bytes;
  }

  Archive archive_;
  std::string root_;  ///< "/assets"
  PackLimits limits_;
  mutable std::mutex mutex_;  ///< of libzip's place in the archive

 private:
  std::map<std::string, zip_uint64_t> index_;  ///< by the path in the archive
  std::vector<std::string> paths_;
  mutable std::size_t total_ = 0;  ///< bytes read so far
};

/// A shader pack in memory as it is compressed: workers that are forked share no place in a file.
class PackZip : public LazyZip {
 public:
  PackZip(std::unique_ptr<const std::string> bytes, Archive archive,
          const std::vector<ZipEntry>& entries, std::string root, const PackLimits& limits)
      : LazyZip(std::move(archive), entries, std::move(root), limits), bytes_(std::move(bytes)) {}
  ~PackZip() override { archive_.reset(); }

  std::optional<std::string> read(std::string_view path) const override {
    const std::lock_guard lock(mutex_);
    return readWhole(root_ + std::string(path));
  }
  std::optional<std::string> readResource(std::string_view path) const override {
    if (!isBesideShaders(path)) return read(path);
    const auto inside = resolvePackPath(root_ + "/", path.substr(1));
    const std::lock_guard lock(mutex_);
    return inside ? readWhole(*inside) : std::nullopt;
  }

  /// Can each file below the root be read, and are they no more than a pack may have?
  bool check(const std::string& zip, std::vector<ZipEntry> entries, Diagnostics& diagnostics) const {
    std::erase_if(entries, [&](const ZipEntry& entry) {
      return entry.folder || !entry.path.starts_with(root_ + "/");
    });
    if (declaredBytes(entries) > limits_.totalBytes) return tooLarge(zip, diagnostics);
    std::set<std::string> known;
    size_t total = 0;
    for (const ZipEntry& entry : entries) {
      const EntryText text = readEntry(archive_.get(), entry.index, limits_.fileBytes, false);
      if (!text.bytes)
        return refuse(zip, entry.path + " in the zip " + text.problem, text.hint, diagnostics);
      total += text.size;
      if (total > limits_.totalBytes) return tooLarge(zip, diagnostics);
      if (!known.insert(entry.path).second)
        return refuse(zip, entry.path + " is twice in the zip", kTwiceHint, diagnostics);
    }
    return true;
  }

 private:
  /// Reading stops at the limit of a file, whatever the archive says.
  std::uint64_t declaredBytes(const std::vector<ZipEntry>& entries) const {
    std::uint64_t total = 0;
    for (const ZipEntry& entry : entries)
      total += std::min<std::uint64_t>(entry.size, limits_.totalBytes + 1);
    return total;
  }

  bool tooLarge(const std::string& zip, Diagnostics& diagnostics) const {
    return addError(diagnostics, "pack-too-large", {zip},
                    fmt::format("the pack has more than {} bytes", limits_.totalBytes));
  }

  static bool refuse(const std::string& zip, std::string message, std::string hint,
                     Diagnostics& diagnostics) {
    return addError(diagnostics, "zip-unreadable", {zip}, std::move(message), std::move(hint));
  }

  std::unique_ptr<const std::string> bytes_;
};

}  // namespace

std::unique_ptr<FileSource> openZipBelow(const std::string& path, const std::string& folder,
                                         const PackLimits& limits, Diagnostics& diagnostics) {
  Archive archive = openArchive(path, diagnostics);
  if (!archive || tooManyFiles(archive.get(), path, limits, diagnostics)) return nullptr;
  const std::vector<ZipEntry> entries = listEntries(archive.get());
  const auto root = findRoot(entries, folder);
  if (!root) return memorySource({});
  addReadPlace(path);
  return std::make_unique<LazyZip>(std::move(archive), entries, *root, limits);
}

std::unique_ptr<FileSource> openPackZip(const std::string& path, const PackLimits& limits,
                                        Diagnostics& diagnostics) {
  ReadFault fault = ReadFault::Missing;
  auto file = readFile(path, limits.zipBytes, fault);
  if (!file) {
    const bool large = fault == ReadFault::TooLarge;
    addError(diagnostics, large ? "pack-too-large" : "zip-unreadable", {path},
             large ? fmt::format("the zip is larger than {} bytes", limits.zipBytes)
                   : fmt::format("the zip {}", describe(fault)));
    return nullptr;
  }
  auto bytes = std::make_unique<const std::string>(std::move(*file));
  Archive archive = openArchive(path, *bytes, diagnostics);
  if (!archive || tooManyFiles(archive.get(), path, limits, diagnostics)) return nullptr;
  std::vector<ZipEntry> entries = listEntries(archive.get());
  const auto root = findRoot(entries);
  if (!root) {
    addError(diagnostics, "pack-unreadable", {path}, "no shader pack: the zip has no folder named shaders",
             "zip the folder that holds shaders/");
    return nullptr;
  }
  auto source =
      std::make_unique<PackZip>(std::move(bytes), std::move(archive), entries, *root, limits);
  return source->check(path, std::move(entries), diagnostics) ? std::move(source) : nullptr;
}

bool isPackZip(const std::string& path) {
  Diagnostics ignored;
  const Archive archive = openArchive(path, ignored);
  return archive && findRoot(listEntries(archive.get()));
}

}  // namespace orris
