// Versions of Iris and of the game: how they are written, which go together, and since when Iris has
// what it has. A loaded pack sees them through its macros, as in the game. docs/versions.md.
#pragma once

#include <compare>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <orris/glsl/preprocess/preprocessor.h>

namespace orris {

/// Iris 1.10.5, Minecraft 1.21.11 or, since versions are years, 26.1.
struct Version {
  int major = 0, minor = 0, patch = 0;
  auto operator<=>(const Version&) const = default;
};
/// "1.8", "1.21.11"; each number at most 99. nullopt for other texts.
std::optional<Version> parseVersion(std::string_view text);
/// "1.21.11"; a patch of 0 is left out: "26.1".
std::string versionText(const Version& version);
/// As IRIS_VERSION and MC_VERSION hold it: two digits each for minor and patch. 1.10.5 is 11005,
/// 26.1 is 260100. Iris: StandardMacros.
int versionNumber(const Version& version);

/// What a pack runs in. The default is the newest pair that this table knows.
struct HostVersions {
  Version iris{1, 11, 2};
  Version game{26, 2, 0};
  bool operator==(const HostVersions&) const = default;
};

/// Versions of Iris that share their first two numbers, and the versions of the game they exist for.
struct IrisSeries {
  Version first, last;
  Version firstGame, lastGame;
};
/// Oldest first.
std::span<const IrisSeries> irisSeries();

/// Which version "1.8" means, and which game goes with it.
enum class SeriesEnd { First, Last };

/// The pair that goes with what is given; "" stands for what fits the other. nullopt, and the reason in `error`, for a version that cannot be read, is unknown, or does not fit.
std::optional<HostVersions> chooseVersions(const std::string& iris, const std::string& game,
                                           SeriesEnd end, std::string& error);

/// What the macros of the environment say. Iris: nullopt where it is not there; of those without
/// IRIS_VERSION it is the last one.
std::optional<Version> irisVersionOf(const MacroDefinitions& environment);
Version gameVersionOf(const MacroDefinitions& environment);

enum class Offer { Macro, Feature, Uniform, Attribute, Property, PixelType, InternalFormat };

/// Something that not every version has.
struct OfferRow {
  Offer kind;
  std::string_view name;
  Version iris;    ///< the first one that has it
  Version game{};  ///< where the game must have it too
};
/// Rows of a kind by name; what has none is as old as the table.
std::span<const OfferRow> offerTable();
const OfferRow* findOffer(Offer kind, std::string_view name);
/// Does this Iris have it? The game is not asked.
bool offers(const Version& iris, Offer kind, std::string_view name);

/// Number of colortex, and of buffer objects. Iris: IrisLimits, ShaderProperties.
int colorBuffersOf(const Version& iris);
int bufferObjectsOf(const Version& iris);
/// The version that raised both.
inline constexpr Version kMoreBuffers{1, 10, 5};

}  // namespace orris
