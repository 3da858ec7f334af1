#include <orris/pack/mods/mods.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace orris {
namespace {

// Iris: DHTerrainTransformer.
constexpr std::array<HostName, 1> kDistantHorizonsNames{
    {{"dhMaterialId", "int dhMaterialId;", Stage::Vertex}}};

// Colorwheel documents these for packs. In the game they carry what the material's shader made, so
// plain variables say enough about their types.
constexpr std::array<HostName, 13> kColorwheelNames{{
    {"clrwl_vertexPos", "vec4 clrwl_vertexPos;"},
    {"clrwl_vertexColor", "vec4 clrwl_vertexColor;"},
    {"clrwl_vertexTexCoord", "vec2 clrwl_vertexTexCoord;"},
    {"clrwl_vertexOverlay", "ivec2 clrwl_vertexOverlay;"},
    {"clrwl_vertexLight", "vec2 clrwl_vertexLight;"},
    {"clrwl_vertexNormal", "vec3 clrwl_vertexNormal;"},
    {"clrwl_vertexTangent", "vec4 clrwl_vertexTangent;"},
    {"clrwl_vertexMidTexCoord", "vec2 clrwl_vertexMidTexCoord;", Stage::Vertex},
    {"clrwl_vertexMidMesh", "vec4 clrwl_vertexMidMesh;", Stage::Vertex},
    {"clrwl_vertexEntity", "vec2 clrwl_vertexEntity;", Stage::Vertex},
    {"clrwl_distance", "float clrwl_distance;"},
    {"clrwl_setVertexOut", "void clrwl_setVertexOut(int vertex) {}", Stage::Geometry},
    {"clrwl_computeFragment",
     "void clrwl_computeFragment(vec4 texel, out vec4 color, out vec2 light, out float occlusion, "
     "out vec4 overlay) { color = texel; light = vec2(0.5); occlusion = 1.0; overlay = vec4(0.0); "
     "}",
     Stage::Fragment},
}};

constexpr std::array<ModFamily, 3> kFamilies{
    {{"Distant Horizons", ProgramGroup::DistantHorizons, "DISTANT_HORIZONS", kDistantHorizonsNames},
     {"Colorwheel", ProgramGroup::Colorwheel, "HAS_COLORWHEEL", kColorwheelNames},
     // Voxy: IrisShaderPatch.SHADER_DEFINE_VERSION, for packs that ask #if VOXY >= 2.
     {"Voxy", ProgramGroup::Voxy, "VOXY", {}, "2"}}};

}  // namespace

std::span<const ModFamily> modFamilies() { return kFamilies; }

const ModFamily* modFamilyOf(ProgramGroup group) {
  const auto found = std::find_if(kFamilies.begin(), kFamilies.end(),
                                  [&](const ModFamily& family) { return family.group == group; });
  return found == kFamilies.end() ? nullptr : &*found;
}

void markAsOfMod(std::string_view mod, Diagnostics& diagnostics) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.severity == Severity::Error) diagnostic.severity = Severity::Warning;
    diagnostic.notes.push_back(fmt::format("this concerns players with {} only", mod));
  }
}

}  // namespace orris
