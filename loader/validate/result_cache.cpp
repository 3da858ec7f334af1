#include <orris/validate/result_cache.h>

#include <sodium.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include <orris/check/workers/diagnostic_codec.h>
#include <orris/core/files/read_file.h>
#include <orris/core/files/replace_file.h>

namespace orris {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// BLAKE2b with 256 bits: a stranger's pack cannot be made to have the hash of another.
class ContentHash {
 public:
  ContentHash() { crypto_generichash_init(&state_, nullptr, 0, crypto_generichash_BYTES); }
  /// With its length, so that texts cannot run into each other.
  void add(std::string_view text) {
    const std::uint64_t size = text.size();
    update({reinterpret_cast<const char*>(&size), sizeof size});
    update(text);
  }
  std::string hex() {
    unsigned char hash[crypto_generichash_BYTES];
    crypto_generichash_final(&state_, hash, sizeof hash);
    char text[2 * sizeof hash + 1];
    sodium_bin2hex(text, sizeof text, hash, sizeof hash);
    return text;
  }

 private:
  void update(std::string_view bytes) {
    crypto_generichash_update(&state_, reinterpret_cast<const unsigned char*>(bytes.data()),
                              bytes.size());
  }
  crypto_generichash_state state_;
};

std::string checksumOf(std::string_view bytes) {
  ContentHash hash;
  hash.add(bytes);
  return hash.hex();
}

std::string readWhole(const std::string& path, std::size_t limit) {
  ReadFault fault;
  return readFile(path, limit, fault).value_or("");
}

constexpr std::size_t kProgramBytes = std::size_t{1} << 30;
// The largest result of 150 public packs has 2 MB.
constexpr std::size_t kEntryBytes = std::size_t{16} << 20;
constexpr std::size_t kEntries = 1000;

/// Every flag that a result depends on.
json flagsOf(const ValidateOptions& options) {
  const auto text = [](const HostVersions& versions) {
    return versionText(versions.iris) + ' ' + versionText(versions.game);
  };
  const auto& versions = options.versions;
  return {options.target->name,
          options.profiles,
          options.dimensions,
          matrixKindName(options.matrix.kind),
          options.matrix.options,
          options.matrix.shard,
          options.matrix.shards,
          options.pack.profile,
          options.pack.values,
          options.pack.settingsFile,
          readWhole(options.pack.settingsFile, kMaxTextBytes),
          options.pack.dimension,
          text(options.pack.versions),
          versions ? text(versions->oldest) + ' ' + text(versions->newest) : ""};
}

/// What ran out of time may end another time.
bool isLasting(const PackVerdict& verdict, const ProblemList& problems) {
  if (verdict.status != kClean && verdict.status != kProblems) return false;
  return std::all_of(verdict.matrices.begin(), verdict.matrices.end(),
                     [](const MatrixSummary& m) { return m.tried == m.configurations; }) &&
         std::none_of(problems.all().begin(), problems.all().end(),
                      [](const Diagnostic& d) { return d.id.starts_with("compiler-"); });
}

json toCache(const ProgramVerdicts& programs) { return {programs.all, programs.failed}; }

ProgramVerdicts fromCache(const json& value) { return {value.at(0), value.at(1)}; }

json toCache(const MatrixSummary& m) {
  return {m.kind,  m.profile,  m.shard,    m.shards, m.configurations,
          m.tried, m.variants, m.compiled, m.all,    m.seconds};
}

MatrixSummary matrixFromCache(const json& v) {
  return {v.at(0), v.at(1), v.at(2), v.at(3), v.at(4), v.at(5), v.at(6), v.at(7), v.at(8), v.at(9)};
}

json toCache(const PackVerdict& verdict) {
  json mods = json::object(), matrices = json::array();
  for (const auto& [mod, programs] : verdict.modPrograms) mods[mod] = toCache(programs);
  for (const MatrixSummary& matrix : verdict.matrices) matrices.push_back(toCache(matrix));
  return {toCache(verdict.programs), mods,          verdict.dimensions, verdict.profiles, matrices,
          verdict.ofMatrix,          verdict.status};
}

void fromCache(const json& value, PackVerdict& verdict) {
  verdict.programs = fromCache(value.at(0));
  for (const auto& [mod, programs] : value.at(1).items())
    verdict.modPrograms[mod] = fromCache(programs);
  value.at(2).get_to(verdict.dimensions);
  value.at(3).get_to(verdict.profiles);
  for (const json& matrix : value.at(4)) verdict.matrices.push_back(matrixFromCache(matrix));
  value.at(5).get_to(verdict.ofMatrix);
  value.at(6).get_to(verdict.status);
}

json toCache(const ProblemList& problems) {
  const Diagnostics& all = problems.all();
  json entryFiles = json::array(), causes = json::array();
  for (std::size_t i = 0; i < all.size(); ++i) {
    entryFiles.push_back(problems.entryFiles(i));
    causes.push_back(problems.cause(i) ? json(*problems.cause(i)) : json());
  }
  const std::string bytes = encodeDiagnostics(all);
  return {json::binary({bytes.begin(), bytes.end()}), entryFiles, causes};
}

void fromCache(const json& value, ProblemList& problems) {
  const auto& bytes = value.at(0).get_binary();
  std::vector<std::optional<std::size_t>> causes;
  for (const json& cause : value.at(2))
    causes.push_back(cause.is_null() ? std::nullopt : std::optional(cause.get<std::size_t>()));
  problems.restore(decodeDiagnostics({reinterpret_cast<const char*>(bytes.data()), bytes.size()}),
                 value.at(1), std::move(causes));
}

void removeOldest(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> entries;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    entries.emplace_back(entry.last_write_time(error), entry.path());
  if (entries.size() <= kEntries) return;
  std::sort(entries.begin(), entries.end());
  entries.resize(entries.size() - kEntries);
  for (const auto& entry : entries) fs::remove(entry.second, error);
}

}  // namespace

std::optional<std::string> ResultCache::keyOf(const FileSource& files,
                                              const ValidateOptions& options) const {
  if (folder_.empty() || options.draw || !options.patched.empty()) return std::nullopt;
  ContentHash hash;
  hash.add(readWhole("/proc/self/exe", kProgramBytes));
  hash.add(flagsOf(options).dump());
  for (const std::string& path : files.files()) {
    const auto bytes = files.read(path);
    if (!bytes) return std::nullopt;
    // It may name files beside `shaders/`, which are not hashed.
    if (path.ends_with(".properties") && bytes->find("..") != std::string::npos)
      return std::nullopt;
    hash.add(path);
    hash.add(*bytes);
  }
  return hash.hex();
}

bool ResultCache::restore(const std::string& key, PackVerdict& verdict, ProblemList& problems) const {
  const std::string bytes = readWhole(folder_ + '/' + key, 2 * kEntryBytes);
  constexpr std::size_t kSum = 2 * crypto_generichash_BYTES;
  if (bytes.size() < kSum) return false;
  const std::string_view content = std::string_view(bytes).substr(kSum);
  if (bytes.substr(0, kSum) != checksumOf(content)) return false;
  const json value = json::from_cbor(content.begin(), content.end());
  fromCache(value.at(0), verdict);
  fromCache(value.at(1), problems);
  verdict.cached = true;
  return true;
}

void ResultCache::keep(const std::string& key, const PackVerdict& verdict,
                       const ProblemList& problems) const {
  if (!isLasting(verdict, problems)) return;
  std::string content;
  json::to_cbor(json::array({toCache(verdict), toCache(problems)}), content);
  if (content.size() > kEntryBytes) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  if (!replaceFile(folder_ + '/' + key, checksumOf(content) + content)) removeOldest(folder_);
}

}  // namespace orris
