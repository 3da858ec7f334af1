#include "app/view/apart/kept_pack.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <new>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include <orris/core/limits.h>
#include <orris/pack/programs/folder_build.h>

namespace orris {
namespace {

using nlohmann::json;
using FileTime = std::filesystem::file_time_type;

// Texts, and the names of files beside them.
constexpr std::size_t kMostKeptBytes = limits::kPackTextBytes + (std::size_t{8} << 20);

std::string linesAsText(const FileLines& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// Of the files as they were read: an edit since then is no part of the pack.
std::vector<std::uint8_t> keptBytesOf(const ShaderPack& pack, const std::string& world) {
  const PackFiles& files = pack.builds.front()->files();
  json texts = json::object();
  for (const auto& [path, lines] : files.graph.files) texts[path] = linesAsText(lines);
  if (files.properties) texts[kPropertiesFile] = *files.properties;
  return json::to_cbor(
      {{"files", pack.source->files()}, {"texts", std::move(texts)}, {"values", pack.values}, {"world", world}});
}

class KeptSource final : public FileSource {
 public:
  KeptSource(const KeptState& state, std::shared_ptr<const FileSource> below)
      : files_(state.files), texts_(state.texts), below_(std::move(below)) {}
  std::optional<std::string> read(std::string_view path) const override {
    const auto found = texts_.find(std::string(path));
    if (found != texts_.end()) return found->second;
    return contains(path) ? below_->read(path) : std::nullopt;
  }
  const std::vector<std::string>& files() const override { return files_; }
  std::optional<std::string> readResource(std::string_view path) const override {
    return isBesideShaders(path) ? below_->readResource(path) : read(path);
  }

 private:
  std::vector<std::string> files_;
  std::map<std::string, std::string> texts_;
  std::shared_ptr<const FileSource> below_;
};

}  // namespace

// A process that dies while it writes leaves the other half whole.
struct KeptPack::Shared {
  struct Half {
    std::size_t size = 0;
    std::array<std::uint8_t, kMostKeptBytes> bytes;
  };
  std::atomic<int> half{-1};  ///< that holds a pack, -1: none
  std::atomic<bool> risk{false};
  std::atomic<FileTime::rep> since{0};  ///< of the risk
  std::array<std::atomic<double>, 9> numbers{};  ///< camera, time and weather of the last frame
  std::atomic<unsigned> panels{0};
  std::array<Half, 2> halves;
};

KeptPack::KeptPack() {
  // Pages that no pack reaches cost nothing.
  void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (memory != MAP_FAILED) shared_ = new (memory) Shared;
}

KeptPack::~KeptPack() {
  if (shared_) munmap(shared_, sizeof(Shared));
}

void KeptPack::drew(const std::shared_ptr<const ShaderPack>& pack, const KeptScene& scene) {
  if (!shared_) return;
  const glm::dvec3& eye = scene.camera.position;
  const std::array<double, 9> numbers{eye.x,      eye.y,      eye.z,        scene.camera.yaw, scene.camera.pitch,
                                      scene.camera.fov, double(scene.time), scene.rain,   scene.thunder};
  for (std::size_t i = 0; i < numbers.size(); ++i) shared_->numbers[i] = numbers[i];
  shared_->panels = scene.panels;
  if (pack == last_ && scene.world == lastWorld_) return;
  last_ = pack;
  lastWorld_ = scene.world;
  const std::vector<std::uint8_t> bytes = keptBytesOf(*pack, scene.world);
  const int free = shared_->half == 0 ? 1 : 0;
  const bool fits = bytes.size() <= kMostKeptBytes;
  if (fits) {
    shared_->halves[free].size = bytes.size();
    std::memcpy(shared_->halves[free].bytes.data(), bytes.data(), bytes.size());
  }
  shared_->half = fits ? free : -1;
}

void KeptPack::setAtRisk(bool risk) {
  if (!shared_) return;
  if (risk && !shared_->risk) shared_->since = FileTime::clock::now().time_since_epoch().count();
  shared_->risk = risk;
}

bool KeptPack::canGoOn() const { return shared_ && shared_->risk && shared_->half >= 0; }

std::optional<KeptState> KeptPack::state() const {
  const int half = shared_ ? shared_->half.load() : -1;
  if (half != 0 && half != 1) return std::nullopt;
  const Shared::Half& kept = shared_->halves[half];
  const json value = json::from_cbor(std::span(kept.bytes.data(), std::min(kept.size, kMostKeptBytes)), true, false);
  KeptState state;
  try {
    value.at("files").get_to(state.files);
    value.at("texts").get_to(state.texts);
    value.at("values").get_to(state.values);
    value.at("world").get_to(state.scene.world);
  } catch (const json::exception&) {
    return std::nullopt;
  }
  std::array<double, 9> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = shared_->numbers[i];
  if (!std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); })) return std::nullopt;
  state.scene.camera = Camera{.name = "",
                              .position = {numbers[0], numbers[1], numbers[2]},
                              .yaw = float(numbers[3]),
                              .pitch = float(numbers[4]),
                              .fov = float(numbers[5])};
  state.scene.time = int(std::clamp(numbers[6], 0.0, 23999.0));
  state.scene.rain = float(numbers[7]);
  state.scene.thunder = float(numbers[8]);
  state.scene.panels = shared_->panels;
  return state;
}

std::filesystem::file_time_type KeptPack::riskSince() const {
  return FileTime(FileTime::duration(shared_ ? shared_->since.load() : 0));
}

std::shared_ptr<const FileSource> keptFiles(const KeptState& state, std::shared_ptr<const FileSource> below) {
  return std::make_shared<KeptSource>(state, std::move(below));
}

}  // namespace orris
