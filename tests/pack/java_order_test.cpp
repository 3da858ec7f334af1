#include <orris/pack/files/java_order.h>

#include <gmock/gmock.h>

namespace orris {
namespace {

using testing::ElementsAre;

// The expected orders were printed by a JDK: a HashMap of keys whose hash is Objects.hash(path).
TEST(JavaHashOrder, is_that_of_a_hash_map) {
  EXPECT_THAT(inJavaHashOrder({"/composite.fsh", "/final.fsh", "/lib/a.glsl", "/lib/b.glsl"}),
              ElementsAre("/composite.fsh", "/lib/a.glsl", "/final.fsh", "/lib/b.glsl"));
}

TEST(JavaHashOrder, a_larger_table_orders_otherwise) {
  std::vector<std::string> paths;
  for (int i = 0; i < 13; ++i) paths.push_back("/lib/" + std::to_string(i) + ".glsl");
  EXPECT_THAT(
      inJavaHashOrder(paths),
      ElementsAre("/lib/5.glsl", "/lib/4.glsl", "/lib/8.glsl", "/lib/10.glsl", "/lib/1.glsl",
                  "/lib/6.glsl", "/lib/12.glsl", "/lib/3.glsl", "/lib/9.glsl", "/lib/0.glsl",
                  "/lib/7.glsl", "/lib/11.glsl", "/lib/2.glsl"));
}

}  // namespace
}  // namespace orris
