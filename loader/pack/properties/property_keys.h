// Readers of single keys of shaders.properties; shader_properties.cpp dispatches to them.
// Contract: properties.csv.
#pragma once

#include <string>
#include <string_view>

#include <orris/pack/files/properties_text.h>
#include <orris/pack/properties/shader_properties.h>
#include <orris/pack/versions/iris_versions.h>

namespace orris {

/// One entry on its way into `out`.
struct PropertyContext {
  ShaderProperties& out;
  const PropertyEntry& entry;
  const OptionSet& options;
  Diagnostics& diagnostics;
  Version iris = HostVersions().iris;  ///< whose features may be required

  /// Reports at `word` of the entry, or at its key.
  void warn(std::string id, std::string message, std::string hint = {},
            std::string_view word = {}) const;
  void fail(std::string id, std::string message, std::string hint = {},
            std::string_view word = {}) const;
  /// A warning that Iris ignores the line, an error that it refuses the whole pack.
  void ignore(std::string id, std::string message, std::string hint = {},
              std::string_view word = {}) const;
  void refuse(std::string id, std::string message, std::string hint = {},
              std::string_view word = {}) const;
};

/// Does a host read keys of this name from shaders.properties?
bool isKnownPropertyKey(std::string_view key);

/// `rest` is the key without the prefix that chose the reader.
using PropertyReader = void (*)(const PropertyContext& context, std::string_view rest);

void readWeather(const PropertyContext& context, std::string_view rest);
void readVolumeLights(const PropertyContext& context, std::string_view rest);
/// The buffer that is drawn to without a program of the pack.
void readFallbackBuffer(const PropertyContext& context, std::string_view rest);
/// Together with what is read so far of the other key.
void readMinimum(const PropertyContext& context, std::string_view rest);

void readProgramEnabled(const PropertyContext& context, std::string_view rest);
void readAlphaTest(const PropertyContext& context, std::string_view program);
void readBlend(const PropertyContext& context, std::string_view rest);
void readFlip(const PropertyContext& context, std::string_view rest);
void readScale(const PropertyContext& context, std::string_view program);
void readBufferSize(const PropertyContext& context, std::string_view buffer);
void readIndirect(const PropertyContext& context, std::string_view program);

void readTexture(const PropertyContext& context, std::string_view rest);
void readCustomTexture(const PropertyContext& context, std::string_view sampler);
void readImage(const PropertyContext& context, std::string_view name);
void readBufferObject(const PropertyContext& context, std::string_view index);

void readUniform(const PropertyContext& context, std::string_view rest);
void readVariable(const PropertyContext& context, std::string_view rest);

/// Screens, sliders, columns and feature flags of the unpreprocessed file.
void readScreens(const std::vector<PropertyEntry>& entries, ShaderProperties& out,
                 const OptionSet& options, const Version& iris, Diagnostics& diagnostics);
/// profile.*: parents applied; recursion and unknown parents are errors.
void readProfiles(const std::vector<PropertyEntry>& entries, ShaderProperties& out,
                  const OptionSet& options, Diagnostics& diagnostics);

/// Keys of shaders.properties that hold one word, and how the others begin ("blend.").
std::vector<std::string_view> settingKeys();
std::vector<std::string_view> propertyPrefixes();

/// "colortex4" for a legacy or current name of a colortex the host has, else "".
std::string knownBuffer(std::string_view name);

}  // namespace orris
