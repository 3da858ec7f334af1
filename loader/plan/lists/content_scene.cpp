#include <orris/plan/lists/content_scene.h>

#include <algorithm>
#include <set>

#include <orris/world/content/armour.h>
#include <orris/world/content/entity_models.h>
#include <orris/world/mesh/block_mesh.h>

namespace orris {
namespace {

using G = Geometry;

/// Those that its model shows.
std::vector<std::string> shownItems(const Entity& entity) {
  const EntityModel* model = findEntityModel(entity.model);
  if (model == nullptr) return {};
  std::vector<std::string> items;
  if (model->carriesItem) items.push_back(entity.item);
  if (model->arms[0] >= 0) items.push_back(entity.mainHand);
  if (model->arms[1] >= 0) items.push_back(entity.offHand);
  std::erase(items, "");
  return items;
}

std::set<std::string> itemsOf(const World& world) {
  std::set<std::string> items;
  for (const Entity& entity : world.content.entities)
    for (const std::string& item : shownItems(entity)) items.insert(item);
  for (const std::string& item :
       {world.environment.player.mainHand, world.environment.player.offHand})
    items.insert(item);
  items.erase("");
  return items;
}

GeometrySet kindsOf(const Entity& entity, const ContentScene& scene) {
  const EntityModel* model = findEntityModel(entity.model);
  GeometrySet kinds = entity.leash ? bitOf(G::Leash) : 0;
  if (entity.glint) kinds |= bitOf(G::Glint);
  if (!entity.tag.empty()) kinds |= bitOf(G::EntitiesTranslucent);
  if (model == nullptr) return kinds;
  for (const ModelBox& box : model->boxes)
    kinds |= bitOf(box.layer == ModelLayer::Eyes          ? G::Eyes
                   : box.layer == ModelLayer::Translucent ? G::EntitiesTranslucent
                                                          : G::Entities);
  for (const std::string& item : shownItems(entity)) {
    const bool translucent = scene.items.at(item).layer == RenderLayer::Translucent;
    kinds |= bitOf(translucent ? G::EntitiesTranslucent : G::Entities);
  }
  return kinds;
}

GeometrySet kindsOf(const World& world, const ContentScene& scene) {
  const WorldContent& content = world.content;
  GeometrySet kinds = 0;
  const auto has = [&](bool present, Geometry kind) { kinds |= present ? bitOf(kind) : 0; };
  for (const Entity& entity : content.entities) kinds |= kindsOf(entity, scene);
  for (const ParticleSource& source : content.particles)
    has(true, source.kind == ParticleKind::Spark ? G::ParticlesTranslucent : G::Particles);
  has(!content.beams.empty(), G::BeamCore);
  has(!content.beams.empty(), G::BeamGlow);
  has(!content.damaged.empty(), G::Cracks);
  has(!content.texts.empty(), G::BlockText);
  has(content.selected.has_value(), G::Outline);
  has(content.border.has_value(), G::Border);
  has(std::any_of(
          world.events.begin(), world.events.end(),
          [](const Event& event) { return std::holds_alternative<StrikeLightning>(event.action); }),
      G::Lightning);
  const Player& player = world.environment.player;
  for (const std::string& item : {player.mainHand, player.offHand}) {
    if (item.empty() || player.hideGui) continue;
    const bool translucent = scene.items.at(item).layer == RenderLayer::Translucent;
    has(true, translucent ? G::HandTranslucent : G::Hand);
    has(player.handGlint && !translucent && item != "minecraft:air", G::HandGlint);
  }
  has(player.body, G::PlayerBody);
  return kinds;
}

std::vector<std::string> texturesFor(const World& world, const ContentScene& scene) {
  std::set<std::string> names;
  const auto add = [&](const std::vector<std::string>& more) {
    names.insert(more.begin(), more.end());
  };
  for (const Entity& entity : world.content.entities) {
    if (const EntityModel* model = findEntityModel(entity.model)) add(texturesOf(*model));
    if (!entity.tag.empty()) names.insert("glyph");
    if (!wornBy(entity).empty()) add({"armour_plate", "armour_helmet"});
  }
  if (world.environment.player.body) add(texturesOf(*findEntityModel("player")));
  for (const auto& [name, facts] : scene.items) {
    add(texturesOf(std::vector<BlockFacts>{facts}));
    if (facts.boxes.empty())
      names.insert(name == "minecraft:air" ? "figure_sleeve" : "item_sprite");
  }
  constexpr const char* kParticles[] = {"flame_particle", "smoke_particle", "spark_particle"};
  for (const ParticleSource& source : world.content.particles)
    names.insert(kParticles[static_cast<int>(source.kind)]);
  for (const DamagedBlock& damage : world.content.damaged) names.insert(crackTexture(damage.stage));
  return {names.begin(), names.end()};
}

/// How often each item is drawn in a frame.
std::map<std::string, ItemUse> itemUses(const World& world, const ContentScene& scene) {
  std::map<std::string, ItemUse> uses;
  for (const auto& [name, facts] : scene.items) uses[name] = {&facts, 2};  // both hands
  for (const Entity& entity : world.content.entities)
    for (const std::string& item : shownItems(entity)) ++uses.at(item).times;
  return uses;
}

void wearResources(const World& world, const ResourceStack& resources,
                   const std::vector<std::string>& textures, ContentScene& scene,
                   Diagnostics& diagnostics) {
  LookTextures worn(resources, diagnostics);
  scene.looks = makeItemLooks(resources, itemUses(world, scene), worn, diagnostics);
  const auto addSkin = [&](const EntityTexture& skin) {
    for (const std::string_view file : skin.files)
      if (!file.empty() && worn.addStill(std::string(skin.name), {"minecraft", std::string(file)})) break;
  };
  const auto addSkins = [&](const EntityModel* model) {
    if (!model) return;
    for (const EntityTexture* skin : skinsOf(*model)) addSkin(*skin);
  };
  for (const Entity& entity : world.content.entities) {
    addSkins(findEntityModel(entity.model));
    for (const WornPiece& each : wornBy(entity)) addSkin(*findEntityTexture(each.piece.skin));
  }
  if (world.environment.player.body) addSkins(findEntityModel("player"));
  for (const std::string& name : textures) worn.addOwn(name);
  worn.finish(scene.atlas);
}

}  // namespace

const ItemLook* ContentScene::lookOf(const std::string& item) const {
  const auto look = looks.find(item);
  return look == looks.end() ? nullptr : &look->second;
}

ContentScene buildContent(const World& world, const ResourceStack* resources,
                          Diagnostics& diagnostics) {
  ContentScene scene;
  const std::set<std::string> items = itemsOf(world);
  if (!items.empty()) {
    const BlockTable table;
    for (const std::string& item : items) {
      BlockFacts facts = table.factsOf({item, {}});
      if (!facts.known) facts.boxes.clear();
      scene.items.emplace(item, std::move(facts));
    }
  }
  scene.kinds = kindsOf(world, scene);
  const std::vector<std::string> textures = texturesFor(world, scene);
  if (textures.empty()) return scene;
  if (resources) {
    wearResources(world, *resources, textures, scene, diagnostics);
  } else {
    scene.atlas = buildAtlas(textures);
  }
  return scene;
}

// Iris: biome_precipitation asks the same.
GeometrySet weatherOf(const Environment& environment) {
  constexpr float kFreezing = 0.15f;
  const bool falls = environment.rain > 0 && environment.dimension == "minecraft:overworld";
  if (falls && environment.temperature < kFreezing) return bitOf(G::Snow);
  return falls && environment.rainfall > 0 ? bitOf(G::Rain) : 0;
}

}  // namespace orris
