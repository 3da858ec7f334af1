// Which outputs a fragment stage has.
#pragma once

#include <cstdint>
#include <string>

namespace orris {

/// Bit n: the final text has an output n, as gl_FragData[n] or declared with that location. All bits where numbers do not
/// stand there: gl_FragColor goes to every buffer, and without a location the driver chooses one.
std::uint32_t outputsOf(const std::string& fragmentText);

}  // namespace orris
