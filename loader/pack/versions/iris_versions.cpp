#include <orris/pack/versions/iris_versions.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include <orris/pack/files/text.h>

namespace orris {
namespace {

// Iris 1.4 was the last one for games before 1.18.2; the table has them with the oldest it knows.
constexpr std::array<IrisSeries, 6> kSeries{{
    {{1, 6, 0}, {1, 6, 17}, {1, 16, 5}, {1, 20, 4}},
    {{1, 7, 0}, {1, 7, 6}, {1, 20, 1}, {1, 21, 0}},
    {{1, 8, 0}, {1, 8, 12}, {1, 21, 0}, {1, 21, 5}},
    {{1, 9, 0}, {1, 9, 7}, {1, 21, 6}, {1, 21, 10}},
    {{1, 10, 0}, {1, 10, 7}, {1, 21, 11}, {26, 1, 0}},
    {{1, 11, 0}, {1, 11, 2}, {26, 1, 0}, {26, 2, 0}},
}};

// The first release after the commit that brought the name, in the history of Iris; the versions
// that the documentation of Iris states win.
constexpr auto kOffers = std::to_array<OfferRow>({
    {Offer::Macro, "IRIS_VERSION", {1, 7, 4}},
    {Offer::Macro, "IRIS_TAG_SUPPORT", {1, 7, 0}},
    {Offer::Macro, "MC_GL_RENDERER_APPLE", {1, 7, 4}},
    {Offer::Macro, "IRIS_HAS_TRANSLUCENCY_SORTING", {1, 8, 0}},
    {Offer::Macro, "MC_MIPMAP_LEVEL", {1, 8, 1}},
    {Offer::Macro, "MAX_COLOR_BUFFERS", kMoreBuffers},
    {Offer::Macro, "IRIS_REQUIRES_SEPARATE_ENTITY_DRAWS", {1, 11, 0}},

    {Offer::Feature, "BLOCK_EMISSION_ATTRIBUTE", {1, 7, 0}},
    {Offer::Feature, "TESSELLATION_SHADERS", {1, 7, 4}},
    {Offer::Feature, "CAN_DISABLE_WEATHER", {1, 8, 0}},
    {Offer::Feature, "TEXTURE_FILTERING", {1, 10, 0}, {1, 21, 11}},
    {Offer::Feature, "FADE_VARIABLE", {1, 10, 3}, {1, 21, 11}},

    {Offer::Uniform, "cameraPositionInt", {1, 7, 0}},
    {Offer::Uniform, "cameraPositionFract", {1, 7, 0}},
    {Offer::Uniform, "previousCameraPositionInt", {1, 7, 0}},
    {Offer::Uniform, "previousCameraPositionFract", {1, 7, 0}},
    {Offer::Uniform, "currentSelectedBlockId", {1, 7, 0}},
    {Offer::Uniform, "currentSelectedBlockPos", {1, 7, 0}},
    {Offer::Uniform, "isRightHanded", {1, 7, 0}},
    {Offer::Uniform, "constantMood", {1, 7, 1}},
    {Offer::Uniform, "heavyFog", {1, 9, 0}, {1, 21, 6}},
    {Offer::Uniform, "endFlashIntensity", {1, 9, 2}, {1, 21, 9}},
    {Offer::Uniform, "endFlashPosition", {1, 9, 2}, {1, 21, 9}},
    {Offer::Uniform, "previousEndFlashIntensity", {1, 9, 2}, {1, 21, 9}},
    {Offer::Uniform, "seaLevel", {1, 9, 5}},
    {Offer::Uniform, "chunkFadeTimeInv", {1, 10, 0}, {1, 21, 11}},
    {Offer::Uniform, "textureFilteringMode", {1, 10, 0}, {1, 21, 11}},
    {Offer::Uniform, "feetInWater", {1, 10, 4}},
    {Offer::Uniform, "inSwimmingAnimation", {1, 10, 4}},
    {Offer::Uniform, "isRiding", {1, 10, 4}},
    {Offer::Uniform, "relativeVehiclePosition", {1, 10, 4}},
    {Offer::Uniform, "vehicleId", {1, 10, 4}},
    {Offer::Uniform, "vehicleInWater", {1, 10, 4}},
    {Offer::Uniform, "vehicleLookVector", {1, 10, 4}},
    {Offer::Uniform, "anisotropicFiltering", {1, 10, 5}, {1, 21, 11}},
    {Offer::Uniform, "isElytraFlying", {1, 10, 6}},
    {Offer::Uniform, "gtextureId", {1, 11, 0}},
    {Offer::Uniform, "textureReloadCount", {1, 11, 0}},

    {Offer::Attribute, "mc_chunkFade", {1, 10, 3}, {1, 21, 11}},

    {Offer::Property, "dhShadow.enabled", {1, 7, 0}},
    {Offer::Property, "occlusion.culling", {1, 7, 0}},
    {Offer::Property, "shadowLightBlockEntities", {1, 7, 0}},
    {Offer::Property, "skipAllRendering", {1, 7, 1}},
    {Offer::Property, "sky", {1, 8, 0}},
    {Offer::Property, "stars", {1, 8, 0}},
    {Offer::Property, "weather", {1, 8, 0}},
    {Offer::Property, "fallbackTex", {1, 8, 6}},
    {Offer::Property, "endFlashShadows", {1, 9, 2}, {1, 21, 9}},
    {Offer::Property, "breaksAnisotropy", kMoreBuffers, {1, 21, 11}},

    {Offer::PixelType, "UNSIGNED_INT_10F_11F_11F_REV", {1, 8, 0}},
    {Offer::PixelType, "UNSIGNED_INT_5_9_9_9_REV", {1, 8, 0}},
    {Offer::InternalFormat, "RGB10_A2UI", {1, 8, 0}},
    {Offer::InternalFormat, "RGB565", {1, 8, 0}},
    {Offer::InternalFormat, "RGBA2", {1, 8, 0}},
    {Offer::InternalFormat, "RGBA4", {1, 8, 0}},
});

// A patch of a year version changes no contract.
Version withoutPatch(Version game) {
  constexpr int kFirstYear = 26;
  if (game.major >= kFirstYear) game.patch = 0;
  return game;
}

bool fitsVersion(const IrisSeries& series, const Version& game) {
  const Version known = withoutPatch(game);
  return series.firstGame <= known && known <= series.lastGame;
}

const IrisSeries* seriesOf(const Version& iris) {
  const auto found = std::find_if(kSeries.begin(), kSeries.end(), [&](const IrisSeries& series) {
    return series.first.major == iris.major && series.first.minor == iris.minor;
  });
  return found == kSeries.end() ? nullptr : &*found;
}

const IrisSeries* newestFor(const Version& game) {
  const auto found = std::find_if(kSeries.rbegin(), kSeries.rend(), [&](const IrisSeries& series) {
    return fitsVersion(series, game);
  });
  return found == kSeries.rend() ? nullptr : &*found;
}

std::string gamesOf(const IrisSeries& series) {
  const std::string first = versionText(series.firstGame), last = versionText(series.lastGame);
  return first == last ? first : first + " to " + last;
}

std::optional<Version> read(const std::string& text, std::string_view what, std::string& error) {
  const auto version = parseVersion(text);
  if (!version) {
    error = fmt::format("\"{}\" is no version of {}, which look like {}", text, what,
                        what == "Iris" ? "1.10.5" : "1.21.11 or 26.1");
  }
  return version;
}

/// The series of what is asked, which is completed where it names no patch.
const IrisSeries* readIris(const std::string& text, SeriesEnd end, Version& iris,
                           std::string& error) {
  const auto asked = read(text, "Iris", error);
  if (!asked) return nullptr;
  const IrisSeries* series = seriesOf(*asked);
  if (series == nullptr) {
    error = fmt::format("Iris {} is unknown; known are {} to {}", text,
                        versionText(kSeries.front().first), versionText(kSeries.back().last));
    return nullptr;
  }
  const bool whole = std::count(text.begin(), text.end(), '.') == 2;
  iris = whole ? *asked : end == SeriesEnd::First ? series->first : series->last;
  return series;
}

const std::string* numberOf(const MacroDefinitions& macros, std::string_view name) {
  const auto found = std::find_if(macros.rbegin(), macros.rend(),
                                  [&](const auto& macro) { return macro.first == name; });
  return found == macros.rend() ? nullptr : &found->second;
}

std::optional<Version> versionIn(const MacroDefinitions& macros, std::string_view name) {
  const std::string* text = numberOf(macros, name);
  const auto number = text == nullptr ? std::nullopt : parseInteger(*text);
  if (!number || *number < 0 || *number > 999999) return std::nullopt;
  const int value = static_cast<int>(*number);
  return Version{value / 10000, value / 100 % 100, value % 100};
}

}  // namespace

std::optional<Version> parseVersion(std::string_view text) {
  const auto parts = splitAt(text, '.');
  if (parts.size() < 2 || parts.size() > 3) return std::nullopt;
  std::array<int, 3> numbers{};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool digits = !parts[i].empty() && parts[i].size() <= 2 &&
                        parts[i].find_first_not_of("0123456789") == std::string_view::npos;
    if (!digits) return std::nullopt;
    numbers[i] = static_cast<int>(*parseInteger(parts[i]));
  }
  return Version{numbers[0], numbers[1], numbers[2]};
}

std::string versionText(const Version& version) {
  std::string text = fmt::format("{}.{}", version.major, version.minor);
  if (version.patch != 0) text += fmt::format(".{}", version.patch);
  return text;
}

int versionNumber(const Version& version) {
  return version.major * 10000 + version.minor * 100 + version.patch;
}

std::span<const IrisSeries> irisSeries() { return kSeries; }

std::optional<HostVersions> chooseVersions(const std::string& iris, const std::string& game,
                                           SeriesEnd end, std::string& error) {
  HostVersions versions;
  const IrisSeries* series = nullptr;
  if (!iris.empty()) {
    series = readIris(iris, end, versions.iris, error);
    if (series == nullptr) return std::nullopt;
    versions.game = end == SeriesEnd::First ? series->firstGame : series->lastGame;
  }
  if (game.empty()) return versions;
  const auto asked = read(game, "Minecraft", error);
  if (!asked) return std::nullopt;
  if (series == nullptr) series = newestFor(*asked);
  if (series == nullptr) {
    error = fmt::format("no Iris is known for Minecraft {}; known are {} to {}", game,
                        versionText(kSeries.front().firstGame), versionText(HostVersions().game));
    return std::nullopt;
  }
  if (!fitsVersion(*series, *asked)) {
    error = fmt::format("Iris {} is for Minecraft {}, not {}", iris, gamesOf(*series), game);
    return std::nullopt;
  }
  return HostVersions{iris.empty() ? series->last : versions.iris, *asked};
}

std::optional<Version> irisVersionOf(const MacroDefinitions& environment) {
  if (const auto version = versionIn(environment, "IRIS_VERSION")) return version;
  if (numberOf(environment, "IS_IRIS") == nullptr) return std::nullopt;
  constexpr Version kLastWithout{1, 7, 3};
  return numberOf(environment, "IRIS_TAG_SUPPORT") == nullptr ? kSeries.front().last : kLastWithout;
}

Version gameVersionOf(const MacroDefinitions& environment) {
  return versionIn(environment, "MC_VERSION").value_or(HostVersions().game);
}

std::span<const OfferRow> offerTable() { return kOffers; }

const OfferRow* findOffer(Offer kind, std::string_view name) {
  const auto found = std::find_if(kOffers.begin(), kOffers.end(), [&](const OfferRow& row) {
    return row.kind == kind && row.name == name;
  });
  return found == kOffers.end() ? nullptr : &*found;
}

bool offers(const Version& iris, Offer kind, std::string_view name) {
  const OfferRow* row = findOffer(kind, name);
  return row == nullptr || row->iris <= iris;
}

int colorBuffersOf(const Version& iris) { return iris < kMoreBuffers ? 16 : 32; }
int bufferObjectsOf(const Version& iris) { return iris < kMoreBuffers ? 9 : 13; }

}  // namespace orris
