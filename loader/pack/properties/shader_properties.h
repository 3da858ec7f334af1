// shaders.properties as typed values. Contract: properties.csv.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <orris/core/diagnostic.h>
#include <orris/glsl/preprocess/preprocessor.h>
#include <orris/pack/expressions/expression.h>
#include <orris/pack/options/options.h>
#include <orris/pack/versions/iris_versions.h>

namespace orris {

/// Factors by GL name without GL_: {"SRC_ALPHA","ONE_MINUS_SRC_ALPHA","ONE","ZERO"}; off: disabled.
struct BlendMode {
  bool off = false;
  std::array<std::string, 4> factors;
  bool operator==(const BlendMode&) const = default;
};

/// alphaTest.<program>: function by name ("GREATER"), reference; off: no test.
struct AlphaTest {
  bool off = false;
  std::string function = "GREATER";
  float reference = 0.1f;
  bool operator==(const AlphaTest&) const = default;
};

/// size.buffer.<buffer>: each axis relative to the window or in pixels.
struct BufferSize {
  std::array<float, 2> size{1, 1};
  std::array<bool, 2> relative{true, true};
};

/// texture.* and customTexture.*: a PNG or resource (rawFormat empty) or raw data.
struct TextureBinding {
  std::string stage;    ///< "gbuffers", "deferred", ... or "" for customTexture (all programs)
  std::string sampler;  ///< sampler name, numeric suffix dropped
  std::string path;     ///< pack path ("/tex/a.png") or resource ("minecraft:textures/...")
  std::string rawType;  ///< "TEXTURE_3D", ... ; empty for an image file
  std::string rawFormat, pixelFormat, pixelType;
  std::array<int, 3> size{1, 1, 1};
  SourceLocation at;
};

/// image.<name>.
struct CustomImage {
  std::string name;
  std::string sampler;  ///< "" for none
  std::string pixelFormat, internalFormat, pixelType;
  bool clear = false;
  bool relative = false;
  int dimensions = 2;
  std::array<float, 3> size{1, 1, 1};  ///< factors of the window when relative, else texels
  SourceLocation at;
};

/// bufferObject.<index>.
struct BufferObject {
  int index = 0;
  long long bytes = 0;
  std::string file;  ///< initial contents, pack path; "" for none
  bool relative = false;
  std::array<float, 2> scale{1, 1};
  SourceLocation at;
};

/// profile.<NAME>: what selecting it sets.
struct Profile {
  std::string name;
  OptionValues values;                        ///< parents already applied
  std::set<std::string> unknownNames;         ///< what it sets that is no option of the pack
  std::vector<std::string> disabledPrograms;  ///< from !program.X
  SourceLocation at;
};

/// screen or screen.<SUB>: entries as written.
struct Screen {
  std::string name;  ///< "" for the main screen
  std::vector<std::string> entries;
  std::optional<int> columns;
  SourceLocation at;
};

struct ShaderProperties {
  std::map<std::string, bool> programEnabled;  ///< key as written: "world0/composite2"
  std::map<std::string, AlphaTest> alphaTest;  ///< by program
  std::map<std::string, BlendMode> blend;      ///< by program
  std::map<std::string, std::map<std::string, BlendMode>> bufferBlend;  ///< program -> buffer
  std::map<std::string, std::map<std::string, bool>> flip;  ///< program -> buffer (canonical name)
  std::map<std::string, std::array<float, 3>> scale;        ///< scale, x, y
  std::map<std::string, BufferSize> bufferSize;             ///< by canonical buffer name
  std::map<std::string, std::pair<int, long long>> indirect;
  std::vector<TextureBinding> textures;
  std::vector<CustomImage> images;
  std::vector<BufferObject> bufferObjects;
  std::vector<CustomUniform> customUniforms;
  std::vector<Profile> profiles;
  std::vector<Screen> screens;
  std::vector<std::string> sliders;
  std::vector<std::string> requiredFeatures, optionalFeatures;  ///< upper case
  std::vector<std::string> optionalAsWritten;
  std::vector<std::string> orrisRequiredFeatures, orrisOptionalFeatures;  ///< our extension
  std::map<std::string, std::string> settings;  ///< every other known key: "separateAo" -> "true"

  /// A boolean setting, `fallback` when unset.
  bool flag(const std::string& key, bool fallback) const;
  /// Does the pack list `name` ("SSBO") as a required or optional feature?
  bool feature(const std::string& name) const;
};

/// The oldest versions that the pack is for, as orris.minimum.iris and orris.minimum.game state them;
/// nullopt when they do not.
std::optional<HostVersions> statedMinimum(const ShaderProperties& properties);

/// "gcolor" -> "colortex0", "gaux1" -> "colortex4"; other names unchanged.
std::string canonicalBuffer(std::string_view name);

/// Parses the file twice as the contract says: preprocessed for most keys, original for profiles,
/// screens, sliders and features. `macros` holds environment and option macros; `watch` learns which
/// of its names the preprocessed text asks for.
ShaderProperties parseShaderProperties(const std::string& file, const std::string& text,
                                       const MacroDefinitions& macros, const OptionSet& options,
                                       Diagnostics& diagnostics, NameWatch* watch = nullptr);

}  // namespace orris
