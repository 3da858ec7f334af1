#include <orris/gl/program.h>

#include <algorithm>
#include <chrono>

#include <orris/gl/functions.h>

namespace orris::gl {
namespace {

using Clock = std::chrono::steady_clock;
double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

using Shader = Handle<deleteShader>;

std::string shaderLog(GLuint shader) {
  GLint length = 0;
  GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
  std::string log(size_t(std::max(length, 0)), '\0');
  GLsizei written = 0;
  if (length > 0) GetShaderInfoLog(shader, length, &written, log.data());
  log.resize(size_t(written));
  return log;
}

std::string programLog(GLuint program) {
  GLint length = 0;
  GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
  std::string log(size_t(std::max(length, 0)), '\0');
  GLsizei written = 0;
  if (length > 0) GetProgramInfoLog(program, length, &written, log.data());
  log.resize(size_t(written));
  return log;
}

// Every stage is compiled even after a failure: one run reports all of them.
std::vector<Shader> compileStages(const std::vector<StageSource>& sources, Program& program) {
  const Clock::time_point start = Clock::now();
  std::vector<Shader> shaders;
  for (const StageSource& source : sources) {
    Shader shader(CreateShader(source.type));
    const GLchar* text = source.text.data();
    const GLint length = GLint(source.text.size());
    ShaderSource(shader.id(), 1, &text, &length);
    CompileShader(shader.id());
    GLint compiled = GL_FALSE;
    GetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    program.stageLogs.push_back(shaderLog(shader.id()));
    program.stageFailed.push_back(compiled != GL_TRUE);
    shaders.push_back(std::move(shader));
  }
  program.compileSeconds = secondsSince(start);
  return shaders;
}

void link(const std::vector<Shader>& shaders,
          const std::vector<std::pair<std::string, int>>& fragmentOutputs, Program& program) {
  const GLuint id = program.id();
  for (const Shader& shader : shaders) AttachShader(id, shader.id());
  for (const auto& [name, index] : fragmentOutputs) {
    BindFragDataLocation(id, GLuint(index), name.c_str());
  }
  const Clock::time_point start = Clock::now();
  LinkProgram(id);
  GLint linked = GL_FALSE;
  GetProgramiv(id, GL_LINK_STATUS, &linked);
  program.linkSeconds = secondsSince(start);
  program.linked = linked == GL_TRUE;
  program.linkLog = programLog(id);
  for (const Shader& shader : shaders) DetachShader(id, shader.id());
}

std::string withoutArraySuffix(std::string name) {
  constexpr std::string_view kSuffix = "[0]";
  if (std::string_view(name).ends_with(kSuffix)) name.resize(name.size() - kSuffix.size());
  return name;
}

using GetActive = decltype(GetActiveUniform);
using GetLocation = decltype(GetUniformLocation);

std::vector<ActiveVariable> listActive(GLuint program, GLenum countName, GLenum lengthName,
                                       GetActive getActive, GetLocation getLocation) {
  GLint count = 0;
  GLint longest = 0;
  GetProgramiv(program, countName, &count);
  GetProgramiv(program, lengthName, &longest);
  std::vector<ActiveVariable> variables;
  std::string name(size_t(std::max(longest, 1)), '\0');
  for (GLint i = 0; i < count; ++i) {
    ActiveVariable variable;
    GLsizei length = 0;
    getActive(program, GLuint(i), GLsizei(name.size()), &length, &variable.size, &variable.type,
              name.data());
    const std::string full = name.substr(0, size_t(length));
    variable.location = getLocation(program, full.c_str());
    variable.name = withoutArraySuffix(full);
    variables.push_back(std::move(variable));
  }
  return variables;
}

void reflect(bool compute, Program& program) {
  const GLuint id = program.id();
  program.uniforms = listActive(id, GL_ACTIVE_UNIFORMS, GL_ACTIVE_UNIFORM_MAX_LENGTH,
                                GetActiveUniform, GetUniformLocation);
  GetProgramInterfaceiv(id, GL_SHADER_STORAGE_BLOCK, GL_ACTIVE_RESOURCES, &program.storageBlocks);
  if (compute) {
    program.computeLocalSize.resize(3);
    GetProgramiv(id, GL_COMPUTE_WORK_GROUP_SIZE, program.computeLocalSize.data());
  } else {
    program.attributes = listActive(id, GL_ACTIVE_ATTRIBUTES, GL_ACTIVE_ATTRIBUTE_MAX_LENGTH,
                                    GetActiveAttrib, GetAttribLocation);
  }
}

struct OpaqueType {
  unsigned type;
  int dimensions;  // 0: no 1D, 2D or 3D texture fits (cube, array, buffer, multisample)
  bool shadow, image;
};
constexpr bool kYes = true;
constexpr bool kNo = false;
constexpr OpaqueType kOpaqueTypes[] = {
    {GL_SAMPLER_1D, 1, kNo, kNo},
    {GL_SAMPLER_2D, 2, kNo, kNo},
    {GL_SAMPLER_3D, 3, kNo, kNo},
    {GL_SAMPLER_1D_SHADOW, 1, kYes, kNo},
    {GL_SAMPLER_2D_SHADOW, 2, kYes, kNo},
    {GL_INT_SAMPLER_1D, 1, kNo, kNo},
    {GL_INT_SAMPLER_2D, 2, kNo, kNo},
    {GL_INT_SAMPLER_3D, 3, kNo, kNo},
    {GL_UNSIGNED_INT_SAMPLER_1D, 1, kNo, kNo},
    {GL_UNSIGNED_INT_SAMPLER_2D, 2, kNo, kNo},
    {GL_UNSIGNED_INT_SAMPLER_3D, 3, kNo, kNo},
    {GL_SAMPLER_2D_RECT, 0, kNo, kNo},
    {GL_SAMPLER_2D_RECT_SHADOW, 0, kYes, kNo},
    {GL_INT_SAMPLER_2D_RECT, 0, kNo, kNo},
    {GL_UNSIGNED_INT_SAMPLER_2D_RECT, 0, kNo, kNo},
    {GL_SAMPLER_CUBE, 0, kNo, kNo},
    {GL_SAMPLER_CUBE_SHADOW, 0, kYes, kNo},
    {GL_INT_SAMPLER_CUBE, 0, kNo, kNo},
    {GL_UNSIGNED_INT_SAMPLER_CUBE, 0, kNo, kNo},
    {GL_SAMPLER_1D_ARRAY, 0, kNo, kNo},
    {GL_SAMPLER_2D_ARRAY, 0, kNo, kNo},
    {GL_SAMPLER_1D_ARRAY_SHADOW, 0, kYes, kNo},
    {GL_SAMPLER_2D_ARRAY_SHADOW, 0, kYes, kNo},
    {GL_INT_SAMPLER_2D_ARRAY, 0, kNo, kNo},
    {GL_UNSIGNED_INT_SAMPLER_2D_ARRAY, 0, kNo, kNo},
    {GL_SAMPLER_BUFFER, 0, kNo, kNo},
    {GL_INT_SAMPLER_BUFFER, 0, kNo, kNo},
    {GL_UNSIGNED_INT_SAMPLER_BUFFER, 0, kNo, kNo},
    {GL_SAMPLER_2D_MULTISAMPLE, 0, kNo, kNo},
    {GL_IMAGE_1D, 1, kNo, kYes},
    {GL_IMAGE_2D, 2, kNo, kYes},
    {GL_IMAGE_3D, 3, kNo, kYes},
    {GL_INT_IMAGE_1D, 1, kNo, kYes},
    {GL_INT_IMAGE_2D, 2, kNo, kYes},
    {GL_INT_IMAGE_3D, 3, kNo, kYes},
    {GL_UNSIGNED_INT_IMAGE_1D, 1, kNo, kYes},
    {GL_UNSIGNED_INT_IMAGE_2D, 2, kNo, kYes},
    {GL_UNSIGNED_INT_IMAGE_3D, 3, kNo, kYes},
    {GL_IMAGE_2D_RECT, 0, kNo, kYes},
    {GL_IMAGE_CUBE, 0, kNo, kYes},
    {GL_IMAGE_BUFFER, 0, kNo, kYes},
    {GL_IMAGE_1D_ARRAY, 0, kNo, kYes},
    {GL_IMAGE_2D_ARRAY, 0, kNo, kYes},
    {GL_INT_IMAGE_2D_ARRAY, 0, kNo, kYes},
    {GL_UNSIGNED_INT_IMAGE_2D_ARRAY, 0, kNo, kYes},
    {GL_INT_IMAGE_BUFFER, 0, kNo, kYes},
    {GL_UNSIGNED_INT_IMAGE_BUFFER, 0, kNo, kYes},
};

const OpaqueType* findOpaque(unsigned type) {
  for (const OpaqueType& row : kOpaqueTypes) {
    if (row.type == type) return &row;
  }
  return nullptr;
}

}  // namespace

Program buildProgram(const std::vector<StageSource>& sources,
                     const std::vector<std::pair<std::string, int>>& fragmentOutputs,
                     const std::string& label) {
  Program program;
  const std::vector<Shader> shaders = compileStages(sources, program);
  const auto& failed = program.stageFailed;
  if (std::find(failed.begin(), failed.end(), true) != failed.end()) return program;
  program.handle = Handle<deleteProgram>(CreateProgram());
  if (!label.empty()) {
    ObjectLabel(GL_PROGRAM, program.id(), GLsizei(label.size()), label.data());
  }
  link(shaders, fragmentOutputs, program);
  if (!program.linked) {
    program.handle = {};
    return program;
  }
  const bool compute = !sources.empty() && sources.front().type == GL_COMPUTE_SHADER;
  reflect(compute, program);
  return program;
}

bool isSampler(unsigned type) {
  const OpaqueType* row = findOpaque(type);
  return row != nullptr && !row->image;
}

bool isShadowSampler(unsigned type) {
  const OpaqueType* row = findOpaque(type);
  return row != nullptr && row->shadow;
}

bool isImage(unsigned type) {
  const OpaqueType* row = findOpaque(type);
  return row != nullptr && row->image;
}

int dimensionsOf(unsigned type) {
  const OpaqueType* row = findOpaque(type);
  return row == nullptr ? 0 : row->dimensions;
}

}  // namespace orris::gl
