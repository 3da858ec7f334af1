// Checking programs with the GL driver, in processes of their own: a driver that dies or hangs on a
// shader takes only its process along.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>

#include <orris/check/compile/program_check.h>
#include <orris/gl/context.h>

namespace orris {

/// The driver that a context of `backend` gets; nullopt: reported.
std::optional<gl::DriverInfo> askDriver(gl::Backend backend, Diagnostics& diagnostics);

/// Compiles and links those units of `pack` that `verdicts` lacks, each in `time` of the processor, and adds
/// their verdicts.
void checkWithDriver(const ShaderPack& pack, gl::Backend backend, std::chrono::seconds time,
                     Verdicts& verdicts, Diagnostics& diagnostics);

/// Addresses that a driver may use: of a software rasteriser as many as the machine has memory, at least
/// 4 GiB; 0, any, of a graphics card, whose driver reserves more than there is.
std::size_t driverMemory(bool software);

/// The most that one program is given.
inline constexpr std::chrono::seconds kProgramTime{30};
/// Of processor time for runWithContext(): a machine without a graphics card may need minutes for a frame.
inline constexpr std::chrono::seconds kDrawTime{300};

/// Runs `work` with a context in a process of its own and returns what it reported; `what` is for
/// the message if it does not end well.
Diagnostics runWithContext(gl::Backend backend, const std::string& what,
                           const std::function<void(gl::Context&, Diagnostics&)>& work,
                           std::chrono::seconds time = kDrawTime);

}  // namespace orris
