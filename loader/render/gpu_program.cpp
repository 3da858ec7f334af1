#include <orris/render/gpu_program.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include <orris/gl/functions.h>
#include <orris/plan/frame/core_profile_uniforms.h>

namespace orris {
namespace {

bool isInteger(ValueType type) {
  return type == ValueType::Bool || type == ValueType::Int || type == ValueType::IVec2 ||
         type == ValueType::IVec3;
}

// Packs declare some uniforms with another type than the host's (hideGUI as int or bool, colours as
// vec3 or vec4): values are converted to what the program declared.
void uploadValue(int location, unsigned type, const Value& value) {
  float f[4];
  int i[4];
  const bool integer = isInteger(value.type);
  for (int k = 0; k < 4; ++k) {
    f[k] = integer ? static_cast<float>(value.i[k]) : value.f[k];
    i[k] = integer ? value.i[k] : static_cast<int>(std::clamp(value.f[k], -2.0e9f, 2.0e9f));
  }
  switch (type) {
    case GL_FLOAT:
      gl::Uniform1f(location, f[0]);
      break;
    case GL_FLOAT_VEC2:
      gl::Uniform2f(location, f[0], f[1]);
      break;
    case GL_FLOAT_VEC3:
      gl::Uniform3f(location, f[0], f[1], f[2]);
      break;
    case GL_FLOAT_VEC4:
      gl::Uniform4f(location, f[0], f[1], f[2], f[3]);
      break;
    case GL_INT:
    case GL_BOOL:
      gl::Uniform1i(location, i[0]);
      break;
    case GL_INT_VEC2:
    case GL_BOOL_VEC2:
      gl::Uniform2i(location, i[0], i[1]);
      break;
    case GL_INT_VEC3:
    case GL_BOOL_VEC3:
      gl::Uniform3i(location, i[0], i[1], i[2]);
      break;
    case GL_INT_VEC4:
    case GL_BOOL_VEC4:
      gl::Uniform4i(location, i[0], i[1], i[2], i[3]);
      break;
    case GL_UNSIGNED_INT:
      gl::Uniform1ui(location, static_cast<unsigned>(i[0]));
      break;
    case GL_FLOAT_MAT3:
      if (value.type == ValueType::Mat3)
        gl::UniformMatrix3fv(location, 1, GL_FALSE, value.f.data());
      break;
    case GL_FLOAT_MAT4:
      if (value.type == ValueType::Mat4)
        gl::UniformMatrix4fv(location, 1, GL_FALSE, value.f.data());
      break;
    default:
      break;
  }
}

int customIndex(const CustomUniforms& custom, const std::string& name) {
  const auto& values = custom.values();
  const auto it =
      std::find_if(values.begin(), values.end(), [&](const auto& v) { return v.first == name; });
  return it == values.end() ? -1 : static_cast<int>(it - values.begin());
}

}  // namespace

void matchUniforms(GpuProgram& program, const CustomUniforms& custom) {
  program.frameUniforms.clear();
  program.drawUniforms.clear();
  program.samplers.clear();
  program.images.clear();
  const bool watershadow =
      std::any_of(program.program.uniforms.begin(), program.program.uniforms.end(),
                  [](const gl::ActiveVariable& u) { return u.name == "watershadow"; });
  for (const gl::ActiveVariable& uniform : program.program.uniforms) {
    if (uniform.location < 0) continue;
    if (gl::isSampler(uniform.type) || gl::isImage(uniform.type)) {
      auto& list = gl::isSampler(uniform.type) ? program.samplers : program.images;
      list.push_back({uniform.name, uniform.type, static_cast<int>(list.size()), uniform.location,
                      parseBufferName(uniform.name, watershadow)});
      continue;
    }
    UniformBinding binding{uniform.location, uniform.type, findUniform(uniform.name),
                           customIndex(custom, uniform.name), uniform.name};
    if (binding.row == nullptr) binding.row = findCoreUniform(uniform.name);
    if (binding.row == nullptr && binding.custom < 0) continue;
    const bool perDraw = binding.row != nullptr && binding.row->perDraw;
    (perDraw ? program.drawUniforms : program.frameUniforms).push_back(std::move(binding));
  }
}

void bindSharedBlocks(GpuProgram& program, std::size_t groups) {
  for (SharedBlock& block : program.sharedBlocks) {
    const std::size_t bytes = block.bytes * std::max<std::size_t>(groups, 1);
    if (block.buffer.size < bytes) block.buffer = gl::createBuffer(bytes, nullptr, "shared memory");
    gl::BindBufferBase(GL_SHADER_STORAGE_BUFFER, block.binding, block.buffer.id());
  }
}

void bindSharedBlocks(GpuProgram& program, unsigned counts, std::size_t offset) {
  if (program.sharedBlocks.empty()) return;
  std::array<std::uint32_t, 3> groups{1, 1, 1};
  gl::MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  gl::GetNamedBufferSubData(counts, static_cast<GLintptr>(offset), sizeof(groups), groups.data());
  bindSharedBlocks(program, std::size_t{groups[0]} * groups[1] * groups[2]);
}

void uploadUniforms(const std::vector<UniformBinding>& uniforms, const FrameState& state,
                    const DrawState& draw, const CustomUniforms& custom) {
  for (const UniformBinding& uniform : uniforms)
    uploadValue(uniform.location, uniform.type,
                uniform.row != nullptr ? uniform.row->value(state, draw)
                                       : custom.values()[uniform.custom].second);
}

}  // namespace orris
