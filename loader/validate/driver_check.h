// Checking programs with the GL driver, in processes of their own: a driver that dies or hangs on a
// shader takes only its process along.
#pragma once

#include <functional>
#include <optional>

#include "check/compile/program_check.h"
#include "gl/context.h"

namespace orris {

/// The driver that a context of `backend` gets; nullopt: reported.
std::optional<gl::DriverInfo> askDriver(gl::Backend backend, Diagnostics& diagnostics);

/// Compiles and links those units of `pack` that `verdicts` lacks, and adds their verdicts.
void checkWithDriver(const ShaderPack& pack, gl::Backend backend, Verdicts& verdicts,
                     Diagnostics& diagnostics);

inline constexpr int kDrawSeconds = 300;  ///< of processor time for runWithContext()

/// Runs `work` with a context in a process of its own and returns what it reported; `what` is for
/// the message if it does not end well.
Diagnostics runWithContext(gl::Backend backend, const std::string& what,
                           const std::function<void(gl::Context&, Diagnostics&)>& work);

}  // namespace orris
