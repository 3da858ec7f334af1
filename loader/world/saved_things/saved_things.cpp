#include <orris/core/limits.h>
#include <orris/world/saved_things/saved_things.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace orris {
namespace {

template <class T, class Place>
void keepThose(std::vector<T>& all, std::size_t& tooFar, Place place) {
  if (all.size() <= limits::kWorldThings) return;
  std::ranges::stable_sort(all, {}, place);
  tooFar += all.size() - limits::kWorldThings;
  all.resize(limits::kWorldThings);
}

template <class T>
void append(std::vector<T>& all, std::vector<T>&& more) {
  std::move(more.begin(), more.end(), std::back_inserter(all));
}

}  // namespace

void keepNearest(SavedThings& things, glm::dvec2 middle) {
  keepThose(things.entities, things.tooFar, [&](const Entity& entity) {
    return glm::distance(glm::dvec2(entity.position.x, entity.position.z), middle);
  });
  keepThose(things.signs, things.tooFar, [&](const SavedSign& sign) {
    return glm::distance(glm::dvec2(sign.at.x, sign.at.z), middle);
  });
}

void join(SavedThings& things, SavedThings&& more) {
  append(things.entities, std::move(more.entities));
  append(things.signs, std::move(more.signs));
  for (const auto& [kind, count] : more.figureless) things.figureless[kind] += count;
  things.damaged += more.damaged;
  things.tooFar += more.tooFar;
  if (things.unreadableChunks == 0) things.problem = more.problem;
  things.unreadableChunks += more.unreadableChunks;
}

}  // namespace orris
