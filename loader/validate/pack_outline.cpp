#include <orris/validate/pack_outline.h>

#include <utility>

#include <orris/plan/frame/uniforms.h>

namespace orris {

std::shared_ptr<const PackOutline> readOutline(const HostVersions& versions,
                                               const ValidateOptions& options,
                                               const Checker& checker,
                                               const std::shared_ptr<const FileSource>& files) {
  auto outline = std::make_shared<PackOutline>(PackOutline{.files = files, .versions = versions});
  auto request = makeLoadRequest(files, options.pack, checker.environment(versions), outline->diagnostics);
  if (!request) return outline;
  request->buildSources = false;
  request->keepGoing = true;
  if (auto pack = loadShaderPack(files, *request, outline->diagnostics))
    outline->pack = std::make_shared<const ShaderPack>(std::move(*pack));
  outline->request = std::move(*request);
  outline->request.buildSources = true;
  outline->request.buildModPrograms = true;
  outline->request.irisTexts = checker.target.iris;
  outline->request.uniformTypes = uniformTypes();
  return outline;
}

}  // namespace orris
