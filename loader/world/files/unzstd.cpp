#include <orris/world/files/unzstd.h>

#include <zstd.h>

#include <memory>

namespace orris {
namespace {

constexpr int kWindowBits = 24;

struct FreeZstd {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

}  // namespace

GunzipResult unzstd(std::string_view input, std::size_t limit, std::string& output) {
  const std::unique_ptr<ZSTD_DCtx, FreeZstd> context(ZSTD_createDCtx());
  if (!context || ZSTD_isError(ZSTD_DCtx_setParameter(context.get(), ZSTD_d_windowLogMax, kWindowBits)))
    return GunzipResult::Corrupt;
  std::string block(ZSTD_DStreamOutSize(), '\0');
  ZSTD_inBuffer source{input.data(), input.size(), 0};
  while (true) {
    ZSTD_outBuffer target{block.data(), block.size(), 0};
    const std::size_t left = ZSTD_decompressStream(context.get(), &target, &source);
    if (ZSTD_isError(left)) return GunzipResult::Corrupt;
    if (output.size() + target.pos > limit) return GunzipResult::TooLarge;
    output.append(block, 0, target.pos);
    if (left == 0) return GunzipResult::Ok;
    if (source.pos == source.size && target.pos < target.size) return GunzipResult::Truncated;
  }
}

}  // namespace orris
