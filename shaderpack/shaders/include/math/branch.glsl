// A branch that costs nothing where no pixel takes it: software rasterisers compute both sides of an `if`, but leave a loop that
// has no turn. It counts nothing: of a loop whose turns all give the same NVIDIA's compiler (580.159) takes
// `int(condition)` turns to be 2^32, which is 15 s a frame.
#if !defined INCLUDED_MATH_BRANCH
#define INCLUDED_MATH_BRANCH

#define BRANCH(condition) for (bool turn = condition; turn; turn = false)

#endif
