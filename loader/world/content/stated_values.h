// Uniforms of what only a player, the settings of a user or the day know: a world may state them.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace orris {

enum class StatedType { Bool, Int, Float, IVec3, Vec3 };

struct StatedUniform {
  std::string_view name;  ///< as packs declare it
  StatedType type;
  std::array<float, 3> otherwise;  ///< where nobody states it
  float low, high;                 ///< of each component
};

/// Contract: uniforms.csv, where the meaning and unit of each stands.
inline constexpr std::array kStatedUniforms = {
    StatedUniform{"anisotropicFiltering", StatedType::Int, {0}, 0, 16},
    StatedUniform{"chunkFadeTimeInv", StatedType::Float, {1 / 750.0f}, 0, 1},  // per millisecond
    StatedUniform{"constantMood", StatedType::Float, {0}, 0, 1},
    StatedUniform{"currentColorSpace", StatedType::Int, {0}, 0, 4},
    // Fixed, so that the same command gives the same bytes on any day.
    StatedUniform{"currentDate", StatedType::IVec3, {2024, 1, 1}, 1, 9999},
    StatedUniform{"currentPlayerAir", StatedType::Float, {-1}, -1, 1},
    StatedUniform{"currentPlayerArmor", StatedType::Float, {-1}, -1, 1},
    StatedUniform{"currentPlayerHealth", StatedType::Float, {-1}, -1, 1},
    StatedUniform{"currentPlayerHunger", StatedType::Float, {-1}, -1, 1},
    StatedUniform{"currentTime", StatedType::IVec3, {12, 0, 0}, 0, 59},
    StatedUniform{"firstPersonCamera", StatedType::Bool, {1}, 0, 1},
    StatedUniform{"heavyFog", StatedType::Bool, {0}, 0, 1},
    StatedUniform{"heldBlockLightColor", StatedType::Vec3, {1, 1, 1}, 0, 1},
    StatedUniform{"heldBlockLightColor2", StatedType::Vec3, {1, 1, 1}, 0, 1},
    StatedUniform{"inSwimmingAnimation", StatedType::Bool, {0}, 0, 1},
    StatedUniform{"isElytraFlying", StatedType::Bool, {0}, 0, 1},
    StatedUniform{"isRiding", StatedType::Bool, {0}, 0, 1},
    StatedUniform{"isRightHanded", StatedType::Bool, {1}, 0, 1},
    StatedUniform{"isSpectator", StatedType::Bool, {0}, 0, 1},
    StatedUniform{"maxPlayerAir", StatedType::Float, {-1}, -1, 1000000},
    StatedUniform{"maxPlayerHealth", StatedType::Float, {-1}, -1, 1000000},
    StatedUniform{"playerMood", StatedType::Float, {0}, 0, 1},
    StatedUniform{"relativeEyePosition", StatedType::Vec3, {0, 0, 0}, -1000, 1000},
    StatedUniform{"relativeVehiclePosition", StatedType::Vec3, {0, 0, 0}, -1000, 1000},
    StatedUniform{"textureFilteringMode", StatedType::Int, {0}, 0, 2},
    StatedUniform{"vehicleId", StatedType::Int, {0}, -1, 65535},
    StatedUniform{"vehicleInWater", StatedType::Bool, {0}, 0, 1},
    StatedUniform{"vehicleLookVector", StatedType::Vec3, {0, 0, 0}, -1, 1}};

/// Those that somebody states, by name.
using StatedValues = std::map<std::string, std::array<float, 3>, std::less<>>;

/// nullptr: a world cannot state this one.
const StatedUniform* findStated(std::string_view name);
/// Numbers that it has.
std::size_t componentCount(const StatedUniform& uniform);
/// Whole numbers where it has such, each in its range?
bool takes(const StatedUniform& uniform, std::span<const float> values);
/// What is stated, or what it is otherwise.
std::array<float, 3> valueIn(const StatedValues& values, const StatedUniform& uniform);

}  // namespace orris
