// Rooms from a seed, so that a method can be judged on scenes that nobody has tuned for.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <orris/world/world.h>

namespace orris {

/// What stands before the seed in the name of such a room: "random:17".
inline constexpr std::string_view kRandomRoom = "random:";

/// The seed of a room's name; nullopt for other names, and for what is no number of 32 bits.
std::optional<std::uint32_t> randomRoomSeed(std::string_view name);

/// One room or two on a meadow: size, materials, openings (holes, panes, clear and stained glass, a missing
/// piece of roof), lamps, lava, water, furniture and the time of day are drawn from the seed. By day there is an
/// opening or a lamp, by night a lamp. The camera "room" stands inside. The same seed gives the same world on
/// every machine: only whole numbers decide.
World randomRoom(std::uint32_t seed);

}  // namespace orris
