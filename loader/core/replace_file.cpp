#include "core/replace_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

namespace orris {

std::error_code replaceFile(const std::string& path,
                            const std::function<bool(const std::string& partial)>& write) {
  const std::string partial = fmt::format("{}.partial-{}", path, ::getpid());
  std::error_code error = std::make_error_code(std::errc::io_error);
  if (write(partial)) std::filesystem::rename(partial, path, error);
  std::error_code ignored;
  if (error) std::filesystem::remove(partial, ignored);
  return error;
}

}  // namespace orris
