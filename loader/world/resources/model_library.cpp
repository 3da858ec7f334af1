#include <orris/world/resources/model_library.h>

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include <orris/core/add_diagnostic.h>
#include <orris/core/limits.h>
#include <orris/world/resources/builtin_models.h>

namespace orris {
namespace {

using Variables = std::map<std::string, std::string>;

/// Follows "#side" to a texture; "" when it leads nowhere or in a circle.
std::string followTexture(const std::string& reference, const Variables& variables) {
  std::string name = reference.starts_with('#') ? reference.substr(1) : reference;
  for (std::size_t steps = 0; steps <= variables.size(); ++steps) {
    const auto found = variables.find(name);
    if (found == variables.end()) return "";
    if (!found->second.starts_with('#')) {
      const auto texture = parseResourceName(found->second);
      return texture ? texture->text() : "";
    }
    name = found->second.substr(1);
  }
  return "";
}

/// "layer0", "layer1" and so on; those of a model that inherits from "builtin/generated".
std::vector<std::string> layersOf(const Variables& variables) {
  std::vector<std::string> layers;
  constexpr std::size_t kMost = 5;
  while (layers.size() < kMost) {
    std::string texture = followTexture("layer" + std::to_string(layers.size()), variables);
    if (texture.empty()) break;
    layers.push_back(std::move(texture));
  }
  return layers;
}

/// What a model does not say its parent does, place by place.
void inheritPoses(const DisplayPoses& parent, DisplayPoses& display) {
  for (std::size_t i = 0; i < kDisplayPlaces; ++i)
    if (!display[i]) display[i] = parent[i];
}

std::optional<ResourceFile> builtin(const ResourceName& name) {
  std::string json = builtinModel(name.text());
  return json.empty() ? std::nullopt : std::optional(ResourceFile{std::move(json), "built in"});
}

}  // namespace

void ModelLibrary::warn(const SourceLocation& at, std::string message, std::string hint) {
  addWarning(diagnostics_, "resource-model", at, std::move(message), std::move(hint));
}

const ModelFile* ModelLibrary::file(const std::string& name, const SourceLocation& askedAt) {
  const auto parsed = parseResourceName(name);
  if (!parsed) {
    warn(askedAt, fmt::format("\"{}\" is no name of a model", name),
         "expected letters a-z, digits, and _ - . / after a namespace: minecraft:block/stone");
    return nullptr;
  }
  const auto [entry, fresh] = files_.try_emplace(parsed->text());
  if (fresh) {
    auto read = resources_.read(*parsed, kModels, diagnostics_);
    if (!read) read = builtin(*parsed);
    if (read) entry->second = parseModel(*read, diagnostics_);
    if (!read) missing_[parsed->text()] = 0;
  }
  if (const auto absent = missing_.find(parsed->text()); absent != missing_.end()) ++absent->second;
  return entry->second ? &*entry->second : nullptr;
}

const ResolvedModel* ModelLibrary::find(const std::string& name, const SourceLocation& askedAt) {
  const auto parsed = parseResourceName(name);
  const auto [entry, fresh] = resolved_.try_emplace(parsed ? parsed->text() : name);
  if (fresh) entry->second = resolve(name, askedAt);
  return entry->second ? &*entry->second : nullptr;
}

// A model goes before its parent: in each variable, in its elements as a whole, in each pose, in ambient occlusion.
std::optional<ResolvedModel> ModelLibrary::resolve(const std::string& name,
                                                   const SourceLocation& askedAt) {
  const ModelFile* model = file(name, askedAt);
  Variables variables;
  const std::vector<ElementTemplate>* elements = nullptr;
  std::optional<bool> ambientOcclusion;
  std::set<const ModelFile*> seen;
  bool flat = false;
  DisplayPoses display;
  while (model) {
    seen.insert(model);
    variables.insert(model->textures.begin(), model->textures.end());
    if (!elements && model->elements) elements = &*model->elements;
    if (!ambientOcclusion) ambientOcclusion = model->ambientOcclusion;
    inheritPoses(model->display, display);
    const auto parent = parseResourceName(model->parent);
    const bool builtin = parent && parent->path.starts_with("builtin/");
    flat = builtin && parent->path == "builtin/generated";
    if (model->parent.empty() || builtin) break;
    const ModelFile* next = file(model->parent, model->parentAt);
    if (seen.contains(next) || seen.size() >= limits::kModelDepth) {
      warn(model->parentAt,
           seen.contains(next)
               ? fmt::format("the model \"{}\" is its own parent", model->parent)
               : fmt::format("more than {} models inherit from each other", limits::kModelDepth));
      return std::nullopt;
    }
    model = next;
  }
  // What the packs lack of the parents may be all that was wanted of them.
  if (!model && !elements) return std::nullopt;
  // Of most elements the parent that is absent would have led there.
  const ModelFile* root = model ? nullptr : file("block/block", {});
  if (root) inheritPoses(root->display, display);
  ResolvedModel resolved;
  resolved.ambientOcclusion = ambientOcclusion.value_or(true);
  resolved.display = display;
  if (elements) resolved.elements = *elements;
  if (flat && !elements) resolved.layers = layersOf(variables);
  for (ElementTemplate& element : resolved.elements) {
    for (auto& face : element.faces) {
      if (face) face->texture = followTexture(face->texture, variables);
    }
  }
  return resolved;
}

}  // namespace orris
