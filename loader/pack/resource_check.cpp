#include "pack/resource_check.h"

#include <fmt/format.h>

#include "pack/pack_files.h"
#include "pack/text.h"
#include "pack/texture_format.h"

namespace orris {
namespace {

void report(Severity severity, std::string id, const SourceLocation& at, std::string message,
            const FileSource& source, std::string hint, Diagnostics& diagnostics) {
  const auto lines = splitLines(source.read(kPropertiesFile).value_or(""));
  const size_t index = static_cast<size_t>(at.line) - 1;
  diagnostics.push_back({.severity = severity,
                         .id = std::move(id),
                         .at = at,
                         .message = std::move(message),
                         .sourceLine = index < lines.size() ? lines[index] : "",
                         .hint = std::move(hint)});
}

bool isResource(const std::string& path) { return path.find(':') != std::string::npos; }

void checkTexture(const TextureBinding& texture, const FileSource& source,
                  Diagnostics& diagnostics) {
  if (isResource(texture.path)) return;
  const auto bytes = source.readResource(texture.path);
  if (!bytes) {
    report(Severity::Warning, "texture-missing", texture.at,
           fmt::format("no such file: {}", texture.path), source, "the sampler is left unbound",
           diagnostics);
    return;
  }
  if (texture.rawType.empty()) return;
  const long long needed = static_cast<long long>(texture.size[0]) * texture.size[1] *
                           texture.size[2] * rawTexelBytes(texture.pixelFormat, texture.pixelType);
  const long long there = static_cast<long long>(bytes->size());
  if (there < needed) {
    report(Severity::Error, "texture-short", texture.at,
           fmt::format("{} has {} bytes, the texture needs {}", texture.path, there, needed),
           source, "", diagnostics);
  }
}

void checkBuffer(const BufferObject& buffer, const FileSource& source, Diagnostics& diagnostics) {
  if (buffer.file.empty()) return;
  const auto bytes = source.readResource(buffer.file);
  if (!bytes) {
    report(Severity::Warning, "buffer-file-missing", buffer.at,
           fmt::format("no such file: {}", buffer.file), source, "the buffer starts as zeros",
           diagnostics);
  } else if (static_cast<long long>(bytes->size()) > buffer.bytes) {
    report(Severity::Error, "buffer-file-long", buffer.at,
           fmt::format("{} has {} bytes, the buffer only {}", buffer.file, bytes->size(),
                       buffer.bytes),
           source, "give the buffer more bytes", diagnostics);
  }
}

}  // namespace

void checkResources(const ShaderProperties& properties, const FileSource& source,
                    Diagnostics& diagnostics) {
  for (const TextureBinding& texture : properties.textures)
    checkTexture(texture, source, diagnostics);
  for (const BufferObject& buffer : properties.bufferObjects)
    checkBuffer(buffer, source, diagnostics);
}

}  // namespace orris
