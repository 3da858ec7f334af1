#include "app/view/pack/plain_pack.h"

namespace orris {

std::shared_ptr<const FileSource> plainPack() {
  // A pack needs one program at least: this one copies what the host's own have drawn.
  static constexpr const char* kVertex =
      "#version 120\n"
      "varying vec2 uv;\n"
      "void main() {\n"
      "  uv = gl_MultiTexCoord0.xy;\n"
      "  gl_Position = ftransform();\n"
      "}\n";
  static constexpr const char* kFragment =
      "#version 120\n"
      "uniform sampler2D colortex0;\n"
      "varying vec2 uv;\n"
      "void main() {\n"
      "  gl_FragColor = texture2D(colortex0, uv);\n"
      "}\n";
  return memorySource({{"/final.vsh", kVertex}, {"/final.fsh", kFragment}});
}

}  // namespace orris
