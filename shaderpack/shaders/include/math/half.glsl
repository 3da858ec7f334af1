// Half floats, as images store them.
#if !defined INCLUDED_MATH_HALF
#define INCLUDED_MATH_HALF

/// Drivers may cut a half float off instead of rounding it, and a loop amplifies that loss: round to
/// its 10 bits here.
vec3 round_to_half(vec3 x) {
    return uintBitsToFloat((floatBitsToUint(x) + 0x1000u) & 0xFFFFE000u);
}

#endif
