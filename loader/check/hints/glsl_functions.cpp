#include <orris/check/hints/glsl_functions.h>

#include <algorithm>

#include <orris/glsl/tokens/text_tokens.h>
#include <orris/pack/files/text.h>

namespace orris {
namespace {

// GLSL 4.50 specification, chapter 8; those of old versions as glsl/rewrite/rewrite.h renames them.
constexpr std::string_view kBuiltIns =
    "abs acos acosh all any asin asinh atan atanh atomicAdd atomicAnd atomicCompSwap atomicCounter "
    "atomicCounterDecrement atomicCounterIncrement atomicExchange atomicMax atomicMin atomicOr "
    "atomicXor barrier bitCount bitfieldExtract bitfieldInsert bitfieldReverse ceil clamp cos cosh "
    "cross dFdx dFdxCoarse dFdxFine dFdy dFdyCoarse dFdyFine degrees determinant distance dot equal "
    "exp exp2 faceforward findLSB findMSB floatBitsToInt floatBitsToUint floor fma fract frexp "
    "ftransform fwidth fwidthCoarse fwidthFine greaterThan greaterThanEqual groupMemoryBarrier "
    "imageAtomicAdd imageAtomicAnd imageAtomicCompSwap imageAtomicExchange imageAtomicMax "
    "imageAtomicMin imageAtomicOr imageAtomicXor imageLoad imageSize imageStore imulExtended "
    "intBitsToFloat interpolateAtCentroid interpolateAtOffset interpolateAtSample inverse "
    "inversesqrt isinf isnan ldexp length lessThan lessThanEqual log log2 matrixCompMult max "
    "memoryBarrier memoryBarrierBuffer memoryBarrierImage memoryBarrierShared min mix mod modf "
    "normalize not notEqual outerProduct packHalf2x16 packSnorm2x16 packSnorm4x8 packUnorm2x16 "
    "packUnorm4x8 pow radians reflect refract round roundEven shadow2D shadow2DLod sign sin sinh "
    "smoothstep sqrt step tan tanh texelFetch texelFetchOffset texture texture2D texture2DLod "
    "texture2DProj texture3D textureCube textureGather textureGatherOffset textureGatherOffsets "
    "textureGrad textureGradOffset textureLod textureLodOffset textureOffset textureProj "
    "textureProjLod textureQueryLevels textureQueryLod textureSamples textureSize transpose trunc "
    "uaddCarry uintBitsToFloat umulExtended unpackHalf2x16 unpackSnorm2x16 unpackSnorm4x8 "
    "unpackUnorm2x16 unpackUnorm4x8 usubBorrow";

}  // namespace

const std::vector<std::string>& builtInFunctions() {
  static const std::vector<std::string> kNames = splitBlanks(kBuiltIns);
  return kNames;
}

std::map<std::string, SourceLocation> definedFunctions(const MappedText& text) {
  std::map<std::string, SourceLocation> functions;
  const std::vector<Token> tokens = tokensOf(text);
  int depth = 0;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (tokens[i].text == "{") ++depth;
    if (tokens[i].text == "}") --depth;
    const bool named = depth == 0 && i > 0 && tokens[i].kind == TokenKind::Identifier &&
                       tokens[i - 1].kind == TokenKind::Identifier && tokens[i + 1].text == "(";
    if (!named || tokens[i].text == "main") continue;
    const Origin& at = tokens[i].origin;
    functions.emplace(tokens[i].text, text.locate(at.line, at.column));
  }
  return functions;
}

}  // namespace orris
