#include <orris/core/files/read_places.h>

#include <algorithm>
#include <mutex>

namespace orris {
namespace {

// One list for the process: a source of files lives wherever its owner keeps it, workers are forked
// wherever work is done, and they meet nowhere else.
std::mutex placesMutex;
std::vector<std::string> places;

}  // namespace

void addReadPlace(const std::string& path) {
  const std::lock_guard lock(placesMutex);
  if (std::find(places.begin(), places.end(), path) == places.end()) places.push_back(path);
}

std::vector<std::string> readPlaces() {
  const std::lock_guard lock(placesMutex);
  return places;
}

}  // namespace orris
