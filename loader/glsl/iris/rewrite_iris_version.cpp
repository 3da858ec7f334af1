// What Iris makes of #version, and what #extension lines mean for it.
#include <algorithm>
#include <array>

#include <orris/glsl/rewrite/rewrite_rules.h>

namespace orris {
namespace {

struct ExtensionVersion {
  std::string_view name;
  int version;  ///< the first of GLSL that contains it
};

constexpr std::array<ExtensionVersion, 24> kExtensionVersions = {{
    {"GL_EXT_gpu_shader4", 130},
    {"GL_EXT_texture_array", 130},
    {"GL_ARB_shader_texture_lod", 130},
    {"GL_EXT_shader_texture_lod", 130},
    {"GL_ARB_uniform_buffer_object", 140},
    {"GL_ARB_explicit_attrib_location", 330},
    {"GL_ARB_shader_bit_encoding", 330},
    {"GL_ARB_texture_gather", 400},
    {"GL_ARB_gpu_shader5", 400},
    {"GL_ARB_gpu_shader_fp64", 400},
    {"GL_ARB_texture_query_lod", 400},
    {"GL_ARB_texture_cube_map_array", 400},
    {"GL_ARB_tessellation_shader", 400},
    {"GL_ARB_separate_shader_objects", 410},
    {"GL_ARB_shading_language_420pack", 420},
    {"GL_ARB_shading_language_packing", 420},
    {"GL_ARB_shader_image_load_store", 420},
    {"GL_ARB_conservative_depth", 420},
    {"GL_ARB_explicit_uniform_location", 430},
    {"GL_ARB_shader_image_size", 430},
    {"GL_ARB_shader_storage_buffer_object", 430},
    {"GL_ARB_compute_shader", 430},
    {"GL_ARB_texture_query_levels", 430},
    {"GL_ARB_derivative_control", 450},
}};

const ExtensionVersion* extensionVersion(std::string_view name) {
  const auto found =
      std::find_if(kExtensionVersions.begin(), kExtensionVersions.end(),
                   [name](const ExtensionVersion& known) { return known.name == name; });
  return found == kExtensionVersions.end() ? nullptr : &*found;
}

}  // namespace

void ruleIrisExtensions(RewriteContext& context) {
  TokenStream& stream = context.stream;
  const bool core = isCoreForIris(stream, *context.iris);
  std::erase_if(stream.extensions, [&context, &stream](const TokenStream::Extension& extension) {
    const ExtensionVersion* known = extensionVersion(extension.name);
    if (!known) return false;
    if (extension.behaviour != "disable" && known->version > stream.version &&
        known->version > kLeastIrisVersion) {
      context.fired("iris-extensions", extension.origin);
      stream.version = known->version;
    }
    return true;
  });
  // A raised version must not make core GLSL of what the author wrote in old GLSL.
  if (!core && stream.version > context.packVersion && stream.profile.empty())
    stream.profile = "compatibility";
}

// Without a profile a version of 150 and more is core; gbuffers_line keeps what it says.
void ruleIrisVersion(RewriteContext& context) {
  TokenStream& stream = context.stream;
  constexpr int kFirstWithCompute = 430;  // for a stage that states none, which is reported
  const bool compute = context.stage == Stage::Compute && stream.version > 0;
  const int least = compute                           ? 0
                    : context.stage == Stage::Compute ? kFirstWithCompute
                                                      : kLeastIrisVersion;
  const int version = std::max(stream.version, least);
  const std::string profile = context.iris->lines ? stream.profile : "";
  if (version == stream.version && profile == stream.profile) return;
  context.fired("iris-version", stream.versionOrigin);
  stream.version = version;
  stream.profile = profile;
}

}  // namespace orris
