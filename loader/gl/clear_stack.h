// What keeps Mesa's software rasteriser from compiling a geometry shader again for each draw.
#pragma once

namespace orris::gl {

/// To be called right before a draw, as its program may have a geometry shader that writes images. Mesa (seen in 22.3.6)
/// looks compiled geometry shaders up by a key of which it leaves 4 bytes per image unwritten: what earlier calls left on
/// the stack decides whether the shader, a second of work, is compiled again. Sets that part of the stack to 0.
void clearStack();

}  // namespace orris::gl
