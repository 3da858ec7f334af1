// bench_packs WORLD WIDTHxHEIGHT ROUNDS PACK... -- NAME=VALUE...: what a frame of each pack costs over that of the first,
// all in one process and frame by frame in turns, so that whatever else the machine does meets all alike. Processor time of
// all threads; only options that a pack has are set. One line of JSON.
#include <fmt/format.h>

#include <charconv>
#include <iostream>
#include <nlohmann/json.hpp>
#include <span>

#include <orris/chart/measure/setting_session.h>
#include <orris/chart/measure/statistics.h>
#include <orris/core/files/file_source.h>
#include <orris/gl/context.h>
#include <orris/world/world.h>

namespace orris {
namespace {

constexpr int kWarmUp = 20;  // frames
constexpr int kVisit = 6;    // frames in a row

struct Plan {
  std::string world;
  int width = 0, height = 0, rounds = 0;
  std::vector<std::string> packs;
  std::map<std::string, std::string> options;
};

int numberOf(std::string_view text) {
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::optional<Plan> readPlan(std::span<char*> words) {
  if (words.size() < 4) return std::nullopt;
  const std::string_view size = words[1];
  const std::size_t cross = std::min(size.find('x'), size.size() - 1);
  Plan plan{words[0],
            numberOf(size.substr(0, cross)),
            numberOf(size.substr(cross + 1)),
            numberOf(words[2]),
            {},
            {}};
  std::size_t i = 3;
  for (; i < words.size() && std::string_view(words[i]) != "--"; ++i)
    plan.packs.push_back(words[i]);
  for (++i; i < words.size(); ++i) {
    const std::string word = words[i];
    const std::size_t equals = std::min(word.find('='), word.size() - 1);
    plan.options[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return plan.width > 0 && plan.height > 0 && plan.rounds > 0 ? std::optional(plan) : std::nullopt;
}

/// Those that the pack has.
OptionValues knownOptions(const Plan& plan, const std::shared_ptr<const FileSource>& files,
                          LoadRequest request, Diagnostics& diagnostics) {
  request.buildSources = false;
  OptionValues known;
  const auto pack = loadShaderPack(files, request, diagnostics);
  for (const auto& [name, value] : plan.options)
    if (pack && pack->options.find(name)) known[name] = value;
  return known;
}

std::unique_ptr<SettingSession> open(gl::Context& context, const Plan& plan,
                                     const std::string& path, const World& world,
                                     Diagnostics& diagnostics) {
  const std::shared_ptr<const FileSource> files = openPack(path, diagnostics);
  if (!files) return nullptr;
  SessionRequest request;
  request.openPack = [files](Diagnostics&) { return files; };
  request.load.dimension = world.environment.dimension;
  request.load.environment = environmentFor(context.driver());
  request.load.values = knownOptions(plan, files, request.load, diagnostics);
  request.renderer = {.width = plan.width, .height = plan.height};
  request.camera = world.cameras.front();
  World still = world;
  still.events.clear();
  auto session = SettingSession::open(context, request, std::move(still), diagnostics);
  for (int frame = 0; session && frame < kWarmUp; ++frame) session->draw(diagnostics);
  return session;
}

nlohmann::json measure(const Plan& plan, std::span<const std::unique_ptr<SettingSession>> sessions,
                       Diagnostics& diagnostics) {
  std::vector<std::vector<TimePair>> pairs(sessions.size());
  for (int round = 0; round < plan.rounds; ++round) {
    std::vector<double> sums(sessions.size());
    for (const std::size_t turn : turns(sessions.size()))
      sums[turn] +=
          median(sessions[turn]->visit(kVisit, FrameClock::Processor, diagnostics).frames) / 2;
    for (std::size_t i = 0; i < sums.size(); ++i) pairs[i].push_back({sums[i], sums[0]});
  }
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const PairedCost cost = pairedCost(pairs[i]);
    rows.push_back({{"pack", plan.packs[i]},
                    {"milliseconds", cost.median},
                    {"ratio", cost.ratio},
                    {"low", cost.ratioInterval.low},
                    {"high", cost.ratioInterval.high}});
  }
  return rows;
}

int run(const Plan& plan) {
  Diagnostics diagnostics;
  const auto context = gl::createContext({}, diagnostics);
  const auto world = loadWorld(plan.world, 0, diagnostics);
  std::vector<std::unique_ptr<SettingSession>> sessions;
  for (const std::string& pack : plan.packs)
    if (context && world) sessions.push_back(open(*context, plan, pack, *world, diagnostics));
  const bool good = !sessions.empty() && std::all_of(sessions.begin(), sessions.end(),
                                                     [](const auto& s) { return s != nullptr; });
  if (good) std::cout << measure(plan, sessions, diagnostics) << '\n';
  for (const Diagnostic& diagnostic : diagnostics)
    if (!good) std::cerr << formatDiagnostic(diagnostic) << '\n';
  return good ? 0 : 1;
}

}  // namespace
}  // namespace orris

int main(int count, char** words) {
  const auto plan = orris::readPlan(std::span(words + 1, std::size_t(std::max(count - 1, 0))));
  if (plan && !plan->packs.empty()) return orris::run(*plan);
  std::cerr << "bench_packs WORLD WIDTHxHEIGHT ROUNDS PACK... -- NAME=VALUE...\n";
  return 2;
}
