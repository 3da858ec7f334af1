// Packs by a grammar: bytes choose its productions, so that most of what a fuzzer makes gets past the readers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace orris {

/// What a name in angle brackets stands for; the first production of each is taken when the bytes have ended, and
/// leads to an end.
using GrammarRules = std::map<std::string_view, std::vector<std::string_view>>;

inline const GrammarRules& packRules() {
  static const GrammarRules kRules = {
      {"pack", {"<file>", "<file><file>", "<file><file><file>", "<file><file><file><file><file><file>"}},
      {"file",
       {"=== /final.fsh\n<fragment>", "=== /composite.fsh\n<fragment>", "=== /composite.vsh\n<vertex>",
        "=== /gbuffers_terrain.fsh\n<fragment>", "=== /gbuffers_terrain.vsh\n<vertex>", "=== /shadow.fsh\n<fragment>",
        "=== /gbuffers_water.gsh\n<geometry>", "=== /deferred.csh\n<compute>", "=== /world-1/composite.fsh\n<fragment>",
        "=== /lib/a.glsl\n<part><part><part>", "=== /lib/b.glsl\n<part><part>", "=== /shaders.properties\n<properties>",
        "=== /block.properties\n<ids>", "=== /dimension.properties\ndimension.world-1=minecraft:the_nether\n",
        "=== /lang/en_us.lang\n<language>"}},
      {"version", {"#version 330 compatibility\n", "#version 120\n", "#version 450 core\n", "#version <number>\n", ""}},
      {"fragment",
       {"<version>void main() { gl_FragData[0] = vec4(<value>); }\n",
        "<version><part><part><part>void main() {\n<statement><statement><statement>}\n",
        "<version><part>layout(location = <number>) out vec4 result;\nvoid main() {\n<statement>  result = vec4(<value>);\n}\n",
        "<include>", "<part><part><statement>"}},
      {"vertex",
       {"<version>void main() { gl_Position = ftransform(); }\n",
        "<version><part><part>void main() {\n<statement>  gl_Position = ftransform();\n}\n", "<include>"}},
      {"geometry",
       {"<version>layout(triangles) in;\nlayout(triangle_strip, max_vertices = 3) out;\n<part>void main() {\n<statement>  "
        "gl_Position = gl_in[0].gl_Position;\n  EmitVertex();\n}\n"}},
      {"compute",
       {"<version>layout(local_size_x = <number>) in;\n<part>const ivec3 workGroups = ivec3(<number>, 1, 1);\nvoid main() "
        "{\n<statement>}\n"}},
      {"part",
       {"\n", "<uniform>", "<varying>", "<option>", "<block>", "<include>", "<constant>", "<comment>", "<function>", "<macro>",
        "<struct>", "<slip>"}},
      {"block",
       {"#ifdef <name>\n<part>#endif\n", "#if <condition>\n<part>#elif <condition>\n<part>#else\n<part>#endif\n",
        "#ifndef <name>\n#define <name>\n<part><part>#endif\n", "#if <condition>\n<part>", "<part>#endif\n", "#else\n<part>"}},
      {"condition",
       {"1", "<name> == <number>", "defined <name>", "!defined(<name>) && <condition>", "(<condition>", "<name> > <number> + <name>",
        "<character>"}},
      {"include", {"#include \"/lib/a.glsl\"\n", "#include \"lib/b.glsl\"\n", "#include \"../a.glsl\"\n", "#include <name>\n"}},
      {"uniform",
       {"uniform sampler2D colortex<number>;\n", "uniform <type> <name>;\n", "uniform float frameTimeCounter;\n",
        "uniform vec3 sunPosition, moonPosition;\n", "uniform <type> viewWidth;\n", "uniform sampler2D shadowtex0;\n",
        "layout(rgba16f) uniform image2D colorimg<number>;\n", "uniform mat4 gbufferModelView;\n"}},
      {"varying",
       {"varying <type> <name>;\n", "in <type> <name>;\n", "out <type> <name>;\n", "flat in int <name>;\n",
        "attribute vec4 mc_Entity;\n", "in vec4 at_tangent, mc_Entity;\n"}},
      {"option",
       {"#define <name>\n", "//#define <name>\n", "#define <name> <number> // [<number> <number> <number>]\n",
        "#define <name> <value> // words [<value> <number>\n", "const float sunPathRotation = <value>; // [<value> <number>]\n"}},
      {"constant",
       {"const int shadowMapResolution = <number>;\n", "const int colortex<number>Format = <format>;\n",
        "/* const int colortex<number>Format = <format>; */\n", "const bool colortex<number>Clear = false;\n",
        "/* RENDERTARGETS: <number>,<number> */\n", "/* DRAWBUFFERS:<number><number> */\n", "const <type> <name> = <value>;\n",
        "const vec4 colortex<number>ClearColor = vec4(<value>);\n", "const float shadowDistance = <value>;\n"}},
      {"format", {"RGBA16F", "R32UI", "RGBA8", "<name>"}},
      {"comment", {"// <name>\n", "/* <name>\n*/\n", "/*\n", "// orris: ignore <name>\n", "*/\n"}},
      {"function",
       {"float <name>(float x) { return x; }\n", "<type> <name>(<type> x, <type> y) {\n<statement>  return <value>;\n}\n",
        "void <name>() {\n<statement>\n"}},
      {"macro",
       {"#define <name>(x) (x * <value>)\n", "#undef <name>\n", "#define <name> <name>\n", "#define <name>(x, y) x ## y\n",
        "#extension GL_ARB_shader_image_load_store : enable\n", "#pragma <name>\n", "#error <name>\n", "#line <number>\n"}},
      {"struct", {"struct S { float a; vec3 b; };\n", "layout(std430, binding = <number>) buffer Data { <type> <name>[]; };\n"}},
      {"statement",
       {"\n", "  <type> <name> = <value>;\n", "  <name> = <value>;\n", "  gl_FragData[<number>] = vec4(<value>);\n",
        "  if (<value> > 0.0) {\n<statement>  }\n", "  for (int i = 0; i < <number>; ++i) {\n<statement>  }\n", "<block>",
        "  return;\n", "  <type> <name>[<number>];\n", "  imageStore(colorimg<number>, ivec2(0), vec4(<value>));\n", "<slip>"}},
      {"value",
       {"1.0", "<number>", "<name>", "<name>(<value>)", "<value> + <value>", "texture(colortex<number>, vec2(<value>)).rgb",
        "texture2D(colortex<number>, gl_FragCoord.xy)", "(<value> * <value>)", "frameTimeCounter", "vec3(<value>, <value>, 0.0)",
        "shadow2D(shadowtex0, vec3(<value>)).x", "<name>[<number>]", "-<value>", "mat3(gbufferModelView) * sunPosition"}},
      {"type", {"float", "vec4", "int", "vec3", "mat4", "sampler2D", "bool", "S"}},
      {"number", {"0", "1", "2", "3", "16", "31", "330", "4096", "-1", "99999999999", "0x7f", "2.5"}},
      {"name", {"A", "B", "FOG", "light", "lihgt", "x", "main", "texcoord", "colortex0", "gl_Vertex", "viewWidth", "BLOOM"}},
      {"slip", {"{\n", "}\n", ")\n", "#\n", "<character>\n", "#endfi\n", "\\\n", "\"\n", "=== /final.vsh\n<vertex>"}},
      {"character", {"$", "\xff", "\t", "\r", "@", "\xe2\x80\xae", "(", "?", "%", ";"}},
      {"properties", {"<property>", "<property><property>", "<property><property><property><property>"}},
      {"property",
       {"sun=false\n", "screen=<name> <empty> [<name>] *\n", "screen.<name>=<name> <profile>\n", "profile.<name>=<name> !<name> <name>=<number>\n",
        "profile.<name>=profile.<name>\n", "sliders=<name> <name>\n", "uniform.float.<name>=<expression>\n",
        "variable.int.<name>=<expression>\n", "program.composite.enabled=<name> && !<name>\n", "blend.composite=<name> ONE ZERO ONE\n",
        "alphaTest.gbuffers_water=GREATER <number>\n", "size.buffer.colortex<number>=<number> <number>\n",
        "texture.noise=<name>.png\n", "customTexture.<name>=<name>.png\n", "image.<name>=<name> RGBA RGBA8 BYTE false false <number> <number>\n",
        "bufferObject.<number>=<number>\n", "iris.features.required=<name> SSBO\n", "#if <condition>\n<property>#endif\n", "<name>=<name>\n",
        "scale.composite=<number>\n", "flip.composite.colortex<number>=true\n", "<character>\n", "shadow.enabled=<name>\n"}},
      {"empty", {"<", "<empty>"}},
      {"profile", {"<", "<profile>"}},
      {"expression",
       {"1.0", "frameTimeCounter", "<name>", "<expression> + <expression>", "if(<expression> > <number>, 1, <expression>)",
        "smooth(<expression>, <number>)", "sin(<expression>)", "(<expression>", "sunPosition.x", "<character>"}},
      {"ids", {"block.<number>=stone oak_leaves:persistent=true\n", "block.<number>=<name>\n<ids>", "layer.cutout=<name>\n", "<block>"}},
      {"language", {"option.<name>=<name>\n", "profile.<name>=<name>\n<language>", "value.<name>.<number>=<name>\n", "screen.<name>=<name>\n"}},
  };
  return kRules;
}

/// The text of a pack (pack_text.h).
class PackGrammar {
 public:
  explicit PackGrammar(std::span<const std::uint8_t> choices) : choices_(choices) {}

  std::string make() {
    expand("<pack>", 0);
    return std::move(text_);
  }

 private:
  static constexpr std::size_t kMostDepth = 24, kMostBytes = 8192;

  std::size_t choose(std::size_t count, std::size_t depth) {
    if (choices_.empty() || depth > kMostDepth || text_.size() > kMostBytes) return 0;
    const std::size_t chosen = choices_.front() % count;
    choices_ = choices_.subspan(1);
    return chosen;
  }

  void expand(std::string_view production, std::size_t depth) {
    while (!production.empty()) {
      const std::size_t open = production.find('<'), close = production.find('>', open);
      const auto rule = close == production.npos ? packRules().end()
                                                 : packRules().find(production.substr(open + 1, close - open - 1));
      if (rule == packRules().end()) {
        const std::size_t plain = open == production.npos ? production.size() : open + 1;
        text_ += production.substr(0, plain);
        production.remove_prefix(plain);
        continue;
      }
      text_ += production.substr(0, open);
      production.remove_prefix(close + 1);
      expand(rule->second[choose(rule->second.size(), depth)], depth + 1);
    }
  }

  std::span<const std::uint8_t> choices_;
  std::string text_;
};

}  // namespace orris
