// The fuzz targets of one program, by name.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// What libFuzzer calls with each input.
using FuzzTarget = int (*)(const std::uint8_t* data, std::size_t size);

/// The target of <name>_fuzz.cpp; null where there is none.
FuzzTarget fuzzTarget(std::string_view name);
