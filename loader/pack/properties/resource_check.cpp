#include <orris/pack/properties/resource_check.h>

#include <fmt/format.h>

#include <orris/core/message_limits.h>
#include <orris/core/files/text_file.h>
#include <orris/pack/files/pack_files.h>
#include <orris/pack/files/text.h>
#include <orris/pack/properties/texture_format.h>

namespace orris {
namespace {

/// Reports with the line of the file, which is read once.
class Reporter {
 public:
  Reporter(const FileSource& source, Diagnostics& diagnostics)
      : source_(source), diagnostics_(diagnostics) {}

  void add(Severity severity, std::string id, const SourceLocation& at, std::string message,
           std::string hint) {
    if (!lines_) lines_ = splitLines(readText(source_, kPropertiesFile).value_or(""));
    const size_t index = static_cast<size_t>(at.line) - 1;
    diagnostics_.push_back(
        {.severity = severity,
         .id = std::move(id),
         .at = at,
         .message = std::move(message),
         .sourceLine = index < lines_->size() ? quotedLine((*lines_)[index], at.column) : "",
         .hint = std::move(hint)});
  }

 private:
  const FileSource& source_;
  Diagnostics& diagnostics_;
  std::optional<std::vector<std::string>> lines_;
};

bool isResource(const std::string& path) { return path.find(':') != std::string::npos; }

void checkTexture(const TextureBinding& texture, const FileSource& source, Reporter& report) {
  if (isResource(texture.path)) return;
  const auto bytes = source.readResource(texture.path);
  if (!bytes) {
    const bool beside = texture.path.starts_with("/../");
    report.add(Severity::Warning, "texture-missing", texture.at,
               fmt::format("no such file: {}", texture.path),
               beside ? "files beside shaders/ are read when the folder around it is given"
                      : "Iris binds the sampler as if this line were not there");
    return;
  }
  if (texture.rawType.empty()) return;
  const long long needed = static_cast<long long>(texture.size[0]) * texture.size[1] *
                           texture.size[2] * rawTexelBytes(texture.pixelFormat, texture.pixelType);
  const long long there = static_cast<long long>(bytes->size());
  if (there < needed) {
    report.add(Severity::Error, "texture-short", texture.at,
               fmt::format("{} has {} bytes, the texture needs {}", texture.path, there, needed),
               "");
  }
}

void checkBuffer(const BufferObject& buffer, const FileSource& source, Reporter& report) {
  if (buffer.file.empty()) return;
  const auto bytes = source.readResource(buffer.file);
  if (!bytes) {
    report.add(Severity::Warning, "buffer-file-missing", buffer.at,
               fmt::format("no such file: {}", buffer.file), "the buffer starts as zeros");
  } else if (static_cast<long long>(bytes->size()) > buffer.bytes) {
    report.add(Severity::Error, "buffer-file-long", buffer.at,
               fmt::format("{} has {} bytes, the buffer only {}", buffer.file, bytes->size(),
                           buffer.bytes),
               "give the buffer more bytes");
  }
}

}  // namespace

void checkResources(const ShaderProperties& properties, const FileSource& source,
                    Diagnostics& diagnostics) {
  Reporter report(source, diagnostics);
  for (const TextureBinding& texture : properties.textures) checkTexture(texture, source, report);
  for (const BufferObject& buffer : properties.bufferObjects) checkBuffer(buffer, source, report);
}

}  // namespace orris
