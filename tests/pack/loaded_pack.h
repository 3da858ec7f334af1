// Stages of small packs in memory.
#pragma once

#include "support/memory_pack.h"

namespace orris {

constexpr const char* kVertex =
    "#version 330 compatibility\nvoid main() { gl_Position = ftransform(); }\n";
constexpr const char* kFragment = "#version 330 compatibility\nvoid main() {}\n";

}  // namespace orris
