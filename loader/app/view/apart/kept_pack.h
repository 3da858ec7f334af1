// What a window goes on with when the process that draws for it dies: the pack as it was when it last drew a
// frame, in memory that outlives that process.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orris/pack/shader_pack.h>
#include <orris/world/world.h>

namespace orris {

/// What a frame showed beside the pack.
struct KeptScene {
  std::string world;  ///< that was chosen in the window, "" for the one it began with
  Camera camera;
  int time = 0;  ///< ticks 0..23999
  float rain = 0, thunder = 0;
  unsigned panels = 0;  ///< that were open, a bit each
};

/// A pack and what was seen with it.
struct KeptState {
  std::vector<std::string> files;            ///< all there were, sorted
  std::map<std::string, std::string> texts;  ///< pack path -> text, of programs and properties
  OptionValues values;                       ///< that are not the default
  KeptScene scene;
};

/// Made before the process that draws is forked. That one writes, the next one reads; who watches them asks
/// canGoOn() alone, for what is here comes from a process that may have been taken over.
class KeptPack {
 public:
  KeptPack();
  ~KeptPack();
  KeptPack(const KeptPack&) = delete;
  KeptPack& operator=(const KeptPack&) = delete;

  /// The pack has drawn a frame.
  void drew(const std::shared_ptr<const ShaderPack>& pack, const KeptScene& scene);
  /// Something else than the pack that is kept is being read, built or drawn for the first time.
  void setAtRisk(bool risk);

  /// Is there a pack that is not the one which the process died of?
  bool canGoOn() const;
  /// nullopt: none is kept.
  std::optional<KeptState> state() const;
  /// Files that are newer have not been read by the process that died.
  std::filesystem::file_time_type riskSince() const;

 private:
  struct Shared;
  Shared* shared_ = nullptr;  ///< nullptr: there is no memory, and nothing is kept
  std::shared_ptr<const ShaderPack> last_;
  std::string lastWorld_;
};

/// The files of `state`; those that are no texts of it are read from `below`.
std::shared_ptr<const FileSource> keptFiles(const KeptState& state, std::shared_ptr<const FileSource> below);

}  // namespace orris
