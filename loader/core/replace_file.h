// Writing a file whole or not at all.
#pragma once

#include <functional>
#include <string>
#include <system_error>

namespace orris {

/// Lets `write` fill a file beside `path` and then puts that in its place, so that whoever reads sees
/// the old file or the whole new one. `write` gets the path to fill and returns whether it could. On an
/// error nothing is left beside `path`, and what was there stays; io_error when `write` failed.
std::error_code replaceFile(const std::string& path,
                            const std::function<bool(const std::string& partial)>& write);

}  // namespace orris
