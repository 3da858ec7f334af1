// What is varied, and each thing measured: a profile, option values and a size.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/image/image_size.h>
#include <orris/pack/shader_pack.h>

namespace orris {

/// The names of axes that are no option.
inline constexpr const char* kProfileAxis = "profile";
inline constexpr const char* kSizeAxis = "size";
inline constexpr std::size_t kMaxSettings = 512;

/// "GI_METHOD", "FLOODFILL_INTERVAL=1,3,8", "profile=LOW,HIGH", "size=160x90,320x180".
struct Axis {
  std::string name;
  std::vector<std::string> values;  ///< none: every value there is
};
Axis parseAxis(const std::string& text);

/// Fills in the values that an axis leaves out and removes repeated ones. false and a diagnostic for
/// each name and value that the pack does not have.
bool resolveAxes(std::vector<Axis>& axes, const ShaderPack& pack, Diagnostics& diagnostics);

struct Setting {
  std::string profile;  ///< "": that of the command line
  OptionValues values;  ///< of its axes only
  ImageSize size;
  std::string series;  ///< what a curve holds together: "GI_METHOD=BOUNCE_1", the first axis
  std::string label;   ///< "GI_METHOD=BOUNCE_1 size=160x90"; "as it is" without axes
};

/// Every combination, the last axis varying fastest. Axes must be resolved. nullopt and a diagnostic
/// when there are more than kMaxSettings.
std::optional<std::vector<Setting>> combine(const std::vector<Axis>& axes, ImageSize size,
                                            Diagnostics& diagnostics);

/// "GI_METHOD=BOUNCE_4,GI_SAMPLES=4,profile=HIGH" as a setting of `size`. nullopt and diagnostics for
/// what the pack does not have.
std::optional<Setting> parseSetting(const std::string& text, const ShaderPack& pack, ImageSize size,
                                    Diagnostics& diagnostics);

/// Does the setting have all that `part` names? A `part` of size 0x0 names no size.
bool includes(const Setting& setting, const Setting& part);

/// The request with a setting's choices over its own.
LoadRequest withSetting(LoadRequest request, const Setting& setting);

/// A name for files: letters of the label that every file system takes, and a hash.
std::string fileStem(const std::string& label);

}  // namespace orris
