// Pictures do not depend on threads, breaks, shards or checkpoints.
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "cube_scene.h"
#include <orris/trace/film/checkpoint.h>

namespace orris {
namespace {

using testing::ElementsAre;

test::Cubes litRoom() {
  test::Cubes cubes = test::roomOf({6, 4, 5}, {glm::vec3(0.6f, 0.5f, 0.7f), glm::vec3(0)});
  cubes[{3, 5, 3}].radiance = glm::vec3(9, 8, 7);
  cubes[{2, 1, 2}] = {glm::vec3(0.8f), glm::vec3(0)};
  return cubes;
}

/// Looks north from the south wall of the room, 90 degrees wide.
TraceCamera camera(int width = 40, int height = 20) {
  TraceCamera made;
  made.width = width;
  made.height = height;
  made.position = {4, 3, 5.5};
  made.projectionInverse = glm::mat4(0);
  made.projectionInverse[0][0] = 1;
  made.projectionInverse[1][1] = 0.5f;
  made.projectionInverse[3] = glm::vec4(0, 0, -1, 1);
  return made;
}

class Films : public testing::Test {
 protected:
  TraceFilm run(TraceFilm film, std::vector<std::uint32_t> passes, int threads) const {
    for (const std::uint32_t pass : passes)
      addSamples(film, scene_, camera(), settings_, pass, threads);
    return film;
  }
  TraceFilm fresh(TraceShard shard = {}) const { return {40, 20, shard}; }

  TraceScene scene_ = test::sceneOf(litRoom());
  TraceSettings settings_{7, -1};
  Diagnostics diagnostics_;
};

void expectEqual(const TraceFilm& a, const TraceFilm& b) {
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_TRUE(a.sums == b.sums) << "some pixel differs";
}

TEST_F(Films, are_the_same_for_any_number_of_threads) {
  const TraceFilm one = run(fresh(), {12}, 1);
  EXPECT_GT(one.noise().mean, 0.05);
  expectEqual(one, run(fresh(), {12}, 2));
  expectEqual(one, run(fresh(), {12}, 7));
}

TEST_F(Films, are_the_same_however_samples_are_divided) {
  expectEqual(run(fresh(), {12}, 2), run(fresh(), {1, 4, 7}, 2));
}

TEST_F(Films, go_on_from_a_checkpoint_as_if_never_stopped) {
  const std::string path = testing::TempDir() + "/film.trace";
  const std::uint64_t key = traceKey(scene_, camera(), settings_);
  ASSERT_TRUE(writeCheckpoint(path, run(fresh(), {5}, 2), key, diagnostics_));
  const auto read = readCheckpoint(path, key, diagnostics_);
  ASSERT_TRUE(read);
  expectEqual(run(fresh(), {12}, 2), run(*read, {7}, 2));
}

TEST_F(Films, of_all_shards_make_the_whole) {
  std::vector<TraceFilm> parts;
  for (int i = 0; i < 3; ++i) parts.push_back(run(fresh({i, 3}), {6}, 2));
  const auto whole = mergeShards({parts[2], parts[0], parts[1]}, {"c", "a", "b"}, diagnostics_);
  ASSERT_TRUE(whole);
  expectEqual(run(fresh(), {6}, 2), *whole);
}

TEST_F(Films, of_shards_that_do_not_fit_are_refused_by_name) {
  const TraceFilm first = run(fresh({0, 2}), {2}, 1), more = run(fresh({1, 2}), {3}, 1);
  EXPECT_FALSE(mergeShards({first, more}, {"a", "b"}, diagnostics_));
  EXPECT_FALSE(mergeShards({first, first}, {"a", "b"}, diagnostics_));
  EXPECT_FALSE(mergeShards({first, fresh({1, 3})}, {"a", "b"}, diagnostics_));
  EXPECT_FALSE(mergeShards({first}, {"a"}, diagnostics_));
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : diagnostics_)
    messages.push_back(diagnostic.at.file + ": " + diagnostic.message);
  EXPECT_THAT(messages,
              ElementsAre("b: has 6 samples a pixel, a has 4", "b: is shard 1/2 again",
                          "b: is one of 3 shards, a one of 2", "a: shard 2/2 is missing"));
}

TEST_F(Films, of_another_picture_or_damaged_are_refused) {
  const std::string path = testing::TempDir() + "/film2.trace";
  const std::uint64_t key = traceKey(scene_, camera(), settings_);
  ASSERT_TRUE(writeCheckpoint(path, run(fresh(), {2}, 1), key, diagnostics_));
  EXPECT_FALSE(readCheckpoint(path, key + 1, diagnostics_));
  {
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(2000);
    file.put('!');
  }
  EXPECT_FALSE(readCheckpoint(path, key, diagnostics_));
  std::filesystem::resize_file(path, 100);
  EXPECT_FALSE(readCheckpoint(path, key, diagnostics_));
  std::ofstream(path) << "not a film";
  EXPECT_FALSE(readCheckpoint(path, key, diagnostics_));
  std::vector<std::string> messages;
  for (const Diagnostic& diagnostic : diagnostics_) messages.push_back(diagnostic.message);
  EXPECT_THAT(messages,
              ElementsAre("is of another world, camera, size, seed, option or version of the tracer", "is damaged",
                          "is damaged", "cannot be read as a checkpoint of trace"));
}

TEST_F(Films, keys_differ_with_scene_camera_and_settings) {
  const std::uint64_t key = traceKey(scene_, camera(), settings_);
  EXPECT_EQ(traceKey(test::sceneOf(litRoom()), camera(), settings_), key);
  test::Cubes other = litRoom();
  other[{2, 1, 2}].albedo.g += 0.01f;
  EXPECT_NE(traceKey(test::sceneOf(other), camera(), settings_), key);
  EXPECT_NE(traceKey(scene_, camera(41, 20), settings_), key);
  EXPECT_NE(traceKey(scene_, camera(), {8, -1}), key);
  EXPECT_NE(traceKey(scene_, camera(), {7, 4}), key);
}

TEST_F(Films, key_differs_with_the_code_of_the_tracer) {
  EXPECT_NE(kTracerCode, 0u);
  EXPECT_EQ(traceKey(scene_, camera(), settings_), traceKey(scene_, camera(), settings_, kTracerCode));
  EXPECT_NE(traceKey(scene_, camera(), settings_), traceKey(scene_, camera(), settings_, kTracerCode + 1));
}

// The halves differ as two seeds do, and as their own spread says.
TEST_F(Films, of_two_seeds_agree_within_their_noise) {
  const TraceFilm a = trace(scene_, camera(), {1, -1}, 200, 2);
  const TraceFilm b = trace(scene_, camera(), {2, -1}, 200, 2);
  double between = 0, within = 0, sum = 0;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 40; ++x) {
      const double a0 = a.half(0, x, y).g, a1 = a.half(1, x, y).g;
      const double b0 = b.half(0, x, y).g, b1 = b.half(1, x, y).g;
      between += std::pow((a0 + a1) / 2 - (b0 + b1) / 2, 2);
      within += (std::pow(a0 - a1, 2) + std::pow(b0 - b1, 2)) / 4;
      sum += (a0 + a1 - b0 - b1) / 2;
    }
  }
  EXPECT_GT(within, 0);
  EXPECT_NEAR(between / within, 1, 0.15);
  EXPECT_LT(std::abs(sum), 4 * std::sqrt(within));
}

TEST_F(Films, noise_falls_with_the_square_root_of_samples) {
  const double few = trace(scene_, camera(), settings_, 50, 2).noise().relative;
  const double many = trace(scene_, camera(), settings_, 800, 2).noise().relative;
  EXPECT_NEAR(few / many, 4, 0.5);
}

TEST_F(Films, hold_numbers_only) {
  const TraceFilm film = trace(scene_, camera(), settings_, 64, 2);
  const ImageF image = film.image();
  EXPECT_EQ(image.channels, 9);
  for (const float value : image.pixels) ASSERT_TRUE(std::isfinite(value) && value >= 0);
}

}  // namespace
}  // namespace orris
