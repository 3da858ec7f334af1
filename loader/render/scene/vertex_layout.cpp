#include <orris/render/scene/vertex_layout.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

#include <orris/gl/functions.h>

namespace orris {
namespace {

bool isIntegerAttribute(unsigned type) {
  static constexpr unsigned kTypes[] = {
      GL_INT,          GL_INT_VEC2,          GL_INT_VEC3,          GL_INT_VEC4,
      GL_UNSIGNED_INT, GL_UNSIGNED_INT_VEC2, GL_UNSIGNED_INT_VEC3, GL_UNSIGNED_INT_VEC4};
  return std::find(std::begin(kTypes), std::end(kTypes), type) != std::end(kTypes);
}

const void* pointer(size_t offset) { return reinterpret_cast<const void*>(offset); }

// Of the texts for a core context (glsl/rewrite/core_names.h).
constexpr VertexAttribute kCoreAttributes[] = {
    {"iris_Position", 3, GL_FLOAT, false, offsetof(GpuVertex, position)},
    {"iris_Normal", 3, GL_BYTE, true, offsetof(GpuVertex, normal)},
    {"iris_Color", 4, GL_UNSIGNED_BYTE, true, offsetof(GpuVertex, color)},
    {"iris_UV0", 2, GL_FLOAT, false, offsetof(GpuVertex, uv)},
    {"iris_UV2", 2, GL_SHORT, false, offsetof(GpuVertex, light)},
    {"iris_MidTexCoord", 2, GL_FLOAT, false, offsetof(GpuVertex, midUv)},
};

const VertexAttribute* findAttribute(std::span<const VertexAttribute> rows,
                                     std::string_view name) {
  const auto row = std::find_if(rows.begin(), rows.end(),
                                [&](const VertexAttribute& r) { return r.name == name; });
  return row == rows.end() ? nullptr : &*row;
}

void setConstant(const gl::ActiveVariable& attribute) {
  float value[4] = {0, 0, 0, 1};
  for (const ConstantAttribute& row : constantAttributes())
    if (row.name == attribute.name) std::copy(row.value, row.value + 4, value);
  if (isIntegerAttribute(attribute.type))
    gl::VertexAttribI4i(attribute.location, static_cast<int>(value[0]), static_cast<int>(value[1]),
                        static_cast<int>(value[2]), static_cast<int>(value[3]));
  else
    gl::VertexAttrib4f(attribute.location, value[0], value[1], value[2], value[3]);
}

void bindGeneric(const gl::ActiveVariable& attribute, const VertexPlace& place) {
  const VertexAttribute* row = findAttribute(vertexAttributes(), attribute.name);
  if (row == nullptr) row = findAttribute(kCoreAttributes, attribute.name);
  if (row == nullptr) return setConstant(attribute);
  gl::EnableVertexAttribArray(attribute.location);
  if (isIntegerAttribute(attribute.type))
    gl::VertexAttribIPointer(attribute.location, row->components, row->type, place.stride,
                             pointer(place.offset + row->offset));
  else
    gl::VertexAttribPointer(attribute.location, row->components, row->type,
                            row->normalized ? GL_TRUE : GL_FALSE, place.stride,
                            pointer(place.offset + row->offset));
}

void bindTexCoord(int unit, int components, unsigned type, int stride, size_t offset) {
  gl::ClientActiveTexture(GL_TEXTURE0 + unit);
  gl::EnableClientState(GL_TEXTURE_COORD_ARRAY);
  gl::TexCoordPointer(components, type, stride, pointer(offset));
}

/// Where old arrays lie among the numbered ones, for drivers that have both at one place (NVIDIA's).
constexpr int kNormalPlace = 2, kColorPlace = 3, kTexCoordPlace = 8;

/// May the array of an old attribute be read? Not where an attribute of the pack has its place, which then reads the array
/// in place of its constant. Where both are in use they lie apart.
bool mayRead(const gl::Program& program, std::string_view name, int place) {
  bool taken = false;
  for (const gl::ActiveVariable& attribute : program.attributes) {
    if (attribute.name == name) return true;
    taken |= attribute.location == place;
  }
  return !taken;
}

void bindOldArrays(const gl::Program& program, const VertexPlace& place) {
  const int stride = place.stride;
  const auto at = [&place](size_t offset) { return pointer(place.offset + offset); };
  gl::EnableClientState(GL_VERTEX_ARRAY);
  gl::VertexPointer(3, GL_FLOAT, stride, at(offsetof(GpuVertex, position)));
  if (mayRead(program, "gl_Normal", kNormalPlace)) {
    gl::EnableClientState(GL_NORMAL_ARRAY);
    gl::NormalPointer(GL_BYTE, stride, at(offsetof(GpuVertex, normal)));
  }
  if (mayRead(program, "gl_Color", kColorPlace)) {
    gl::EnableClientState(GL_COLOR_ARRAY);
    gl::ColorPointer(4, GL_UNSIGNED_BYTE, stride, at(offsetof(GpuVertex, color)));
  }
  struct TexCoord {
    const char* name;
    int components;
    unsigned type;
    size_t offset;
  };
  constexpr TexCoord kTexCoords[] = {{"gl_MultiTexCoord0", 2, GL_FLOAT, offsetof(GpuVertex, uv)},
                                     {"gl_MultiTexCoord1", 2, GL_SHORT, offsetof(GpuVertex, light)},
                                     {"gl_MultiTexCoord2", 2, GL_SHORT, offsetof(GpuVertex, light)},
                                     {"gl_MultiTexCoord3", 2, GL_FLOAT, offsetof(GpuVertex, midUv)}};
  for (int unit = 0; unit < 4; ++unit) {
    const TexCoord& row = kTexCoords[unit];
    if (mayRead(program, row.name, kTexCoordPlace + unit))
      bindTexCoord(unit, row.components, row.type, stride, place.offset + row.offset);
  }
}

void unbindOldArrays() {
  for (int unit = 3; unit >= 0; --unit) {
    gl::ClientActiveTexture(GL_TEXTURE0 + unit);
    gl::DisableClientState(GL_TEXTURE_COORD_ARRAY);
  }
  gl::DisableClientState(GL_COLOR_ARRAY);
  gl::DisableClientState(GL_NORMAL_ARRAY);
  gl::DisableClientState(GL_VERTEX_ARRAY);
}

}  // namespace

void bindVertices(const gl::Program& program, const VertexPlace& place) {
  if (!gl::isCoreProfile()) bindOldArrays(program, place);
  for (const gl::ActiveVariable& attribute : program.attributes)
    if (attribute.location >= 0) bindGeneric(attribute, place);
}

void unbindVertices(const gl::Program& program) {
  for (const gl::ActiveVariable& attribute : program.attributes)
    if (attribute.location >= 0) gl::DisableVertexAttribArray(attribute.location);
  if (!gl::isCoreProfile()) unbindOldArrays();
}

void setChunkFade(const gl::Program& program) {
  for (const gl::ActiveVariable& attribute : program.attributes) {
    if (attribute.name == "mc_chunkFade" && attribute.location >= 0)
      gl::VertexAttrib4f(attribute.location, 1, 0, 0, 1);
  }
}

void setOverlay(const gl::Program& program, bool hurt) {
  // Rows of the game's overlay texture.
  constexpr int kHurtRow = 3, kPlainRow = 10;
  const int row = hurt ? kHurtRow : kPlainRow;
  for (const gl::ActiveVariable& attribute : program.attributes) {
    if (attribute.name != "vaUV1" || attribute.location < 0) continue;
    if (isIntegerAttribute(attribute.type))
      gl::VertexAttribI4i(attribute.location, 0, row, 0, 1);
    else
      gl::VertexAttrib4f(attribute.location, 0, static_cast<float>(row), 0, 1);
  }
}

void setConstantColor(const gl::Program& program, const glm::vec4& color) {
  if (!gl::isCoreProfile() && mayRead(program, "gl_Color", kColorPlace)) {
    gl::DisableClientState(GL_COLOR_ARRAY);
    gl::Color4f(color.r, color.g, color.b, color.a);
  }
  for (const gl::ActiveVariable& attribute : program.attributes) {
    const bool isColor = attribute.name == "vaColor" || attribute.name == "iris_Color";
    if (!isColor || attribute.location < 0) continue;
    gl::DisableVertexAttribArray(attribute.location);
    gl::VertexAttrib4f(attribute.location, color.r, color.g, color.b, color.a);
  }
}

}  // namespace orris
