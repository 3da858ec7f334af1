// An engine's own geometry: that it, and nothing else, was drawn, by which programs and with which values.
#include <limits>

#include "api/api_fixture.h"
#include "api/own_context.h"

namespace orris_test {
namespace {

using testing::HasSubstr;

constexpr Rgb kBackground{0, 0, 0};

class Geometry : public ApiTest {
 protected:
  void SetUp() override {
    ApiTest::SetUp();
    if (context_ == nullptr) return;
    renderer_ = make(request(testPack()));
    ASSERT_NE(renderer_, nullptr);
    frame_ = frameOf(renderer_);
    frame_.camera.yaw = 180;  // looks north, along -z
    frame_.camera.fov = 90;
    for (float& part : frame_.fog_color) part = 0;  // the background
  }

  static OrrisVertex vertex(float x, float y, float z, float u, float v) {
    OrrisVertex vertex;
    std::memset(&vertex, 0, sizeof(vertex));
    vertex.position[0] = x;
    vertex.position[1] = y;
    vertex.position[2] = z;
    vertex.uv[0] = u;
    vertex.uv[1] = v;
    vertex.normal[2] = 127;
    vertex.color[3] = 255;
    vertex.entity[0] = vertex.entity[1] = -1;
    vertex.light[0] = vertex.light[1] = 240;
    return vertex;
  }
  /// A quad that faces south at z -4, around a place; half of the picture is 4 blocks high.
  static std::vector<OrrisVertex> quad(float x, float y, float half, Rgb color) {
    std::vector<OrrisVertex> corners = {
        vertex(x - half, y - half, -4, 0, 1), vertex(x + half, y - half, -4, 1, 1),
        vertex(x + half, y + half, -4, 1, 0), vertex(x - half, y + half, -4, 0, 0)};
    for (OrrisVertex& corner : corners)
      for (std::size_t c = 0; c < 3; ++c) corner.color[c] = static_cast<std::uint8_t>(color[c]);
    return corners;
  }
  std::uint32_t buffer(const void* data, std::size_t bytes) {
    std::uint32_t name = 0;
    EXPECT_EQ(orris_buffer_create(context_, data, bytes, &name), ORRIS_OK) << orris_last_error();
    return name;
  }
  OrrisBatch batch(OrrisKind kind, const std::vector<OrrisVertex>& vertices) {
    OrrisBatch batch;
    orris_batch_init(&batch, sizeof(batch));
    batch.kind = kind;
    batch.vertex_buffer = buffer(vertices.data(), vertices.size() * sizeof(OrrisVertex));
    batch.count = static_cast<std::uint32_t>(vertices.size());
    for (int i = 0; i < 3; ++i) batch.origin[i] = frame_.camera.position[i];
    return batch;
  }
  void submit(const OrrisBatch& batch) {
    EXPECT_EQ(orris_renderer_submit(renderer_, &batch), ORRIS_OK) << orris_last_error();
  }
  std::vector<unsigned char> draw() {
    EXPECT_EQ(orris_renderer_draw_frame(renderer_, &frame_), ORRIS_OK) << orris_last_error();
    return read(renderer_);
  }
  static Rgb middle(const std::vector<unsigned char>& pixels) { return at(pixels, 32, 24); }
  static int count(const std::vector<unsigned char>& pixels, Rgb color) {
    int found = 0;
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) found += at(pixels, x, y) == color;
    return found;
  }

  OrrisRenderer* renderer_ = nullptr;
  OrrisFrame frame_;
};

TEST_F(Geometry, of_the_engine_is_all_that_is_drawn) {
  EXPECT_EQ(count(draw(), kBackground), kWidth * kHeight) << "nothing was submitted";
  submit(batch(ORRIS_KIND_SOLID, quad(0, 0, 2, {10, 200, 30})));
  const auto pixels = draw();
  // 4 of 8 blocks of the height, and as many pixels of the width.
  EXPECT_EQ(count(pixels, {10, 200, 30}), 24 * 24);
  EXPECT_EQ(count(pixels, kBackground), kWidth * kHeight - 24 * 24);
  EXPECT_EQ(count(draw(), kBackground), kWidth * kHeight) << "a batch is for one frame";
}

TEST_F(Geometry, stands_where_it_is_in_the_world_and_up_is_up) {
  frame_.camera.position[0] = 1000000;  // far from the origin: floats would not do
  frame_.camera.position[1] = 70.5;
  OrrisBatch high = batch(ORRIS_KIND_SOLID, quad(0, 0, 0.5f, {255, 255, 255}));
  high.origin[1] += 3;
  submit(high);
  const auto pixels = draw();
  EXPECT_EQ(at(pixels, 32, 6), (Rgb{255, 255, 255}));
  EXPECT_EQ(count(pixels, {255, 255, 255}), 36);
}

TEST_F(Geometry, of_every_kind_is_drawn_by_its_program) {
  for (int i = 0; i < ORRIS_KIND_COUNT; ++i) {
    const auto kind = static_cast<OrrisKind>(i);
    if (kind == ORRIS_KIND_SHADOW_ONLY || kind == ORRIS_KIND_GLINT || kind == ORRIS_KIND_CRACKS)
      continue;
    OrrisBatch one = batch(kind, quad(0, 0, 2, {90, 80, 70}));
    if (kind == ORRIS_KIND_HAND || kind == ORRIS_KIND_HAND_TRANSLUCENT)
      for (double& part : one.origin) part = 1e6;  // hands know no place
    submit(one);
    EXPECT_NE(middle(draw()), kBackground) << "kind " << i;
  }
}

TEST_F(Geometry, takes_texture_and_block_id_as_the_pack_sees_them) {
  const unsigned char texels[2 * 2 * 4] = {255, 0, 0,   255, 0, 255, 0, 255,
                                           0,   0, 255, 255, 9, 9,   9, 255};
  OrrisBatch one = batch(ORRIS_KIND_SOLID, quad(0, 0, 2, {255, 255, 255}));
  ASSERT_EQ(orris_texture_create(context_, 2, 2, texels, 1, &one.textures.albedo), ORRIS_OK);
  submit(one);
  const auto pixels = draw();
  EXPECT_EQ(at(pixels, 26, 18), (Rgb{255, 0, 0})) << "top left of the texture";
  EXPECT_EQ(at(pixels, 38, 30), (Rgb{9, 9, 9}));
  auto gold = quad(0, 0, 2, {255, 255, 255});
  for (OrrisVertex& corner : gold)
    ASSERT_EQ(orris_renderer_block_id(renderer_, "minecraft:gold_block", &corner.entity[0]),
              ORRIS_OK);
  EXPECT_EQ(gold[0].entity[0], 7);
  submit(batch(ORRIS_KIND_CUTOUT, gold));
  EXPECT_NEAR(middle(draw())[2], 0.7 * 255, 1) << "block 7 of 10";
  int id = 0;
  EXPECT_EQ(orris_renderer_block_id(renderer_, "minecraft:dirt", &id), ORRIS_OK);
  EXPECT_EQ(id, -1);
  EXPECT_EQ(orris_renderer_block_id(renderer_, "minecraft:oak_log[axis", &id),
            ORRIS_ERROR_ARGUMENT);
  EXPECT_EQ(orris_texture_destroy(context_, one.textures.albedo), ORRIS_OK);
  EXPECT_EQ(orris_buffer_destroy(context_, one.vertex_buffer), ORRIS_OK);
}

TEST_F(Geometry, entities_have_ids_and_colours_of_their_own) {
  OrrisBatch pig = batch(ORRIS_KIND_ENTITY, quad(-2, 0, 1, {10, 200, 30})), other = pig, hurt = pig;
  ASSERT_EQ(orris_renderer_entity_id(renderer_, "minecraft:pig", &pig.entity), ORRIS_OK);
  ASSERT_EQ(orris_renderer_entity_id(renderer_, "minecraft:cow", &other.entity), ORRIS_OK);
  EXPECT_EQ(pig.entity, 5);
  EXPECT_EQ(other.entity, 65535);
  other.origin[0] += 2;
  hurt.origin[0] += 4;
  hurt.entity_color[2] = hurt.entity_color[3] = 1;
  for (const OrrisBatch& one : {pig, other, hurt}) submit(one);
  const auto pixels = draw();
  EXPECT_EQ(at(pixels, 20, 24), (Rgb{255, 0, 0}));
  EXPECT_EQ(at(pixels, 32, 24), (Rgb{10, 200, 30}));
  EXPECT_EQ(at(pixels, 44, 24), (Rgb{0, 0, 255}));
}

TEST_F(Geometry, casts_a_shadow_unless_the_batch_says_otherwise) {
  ASSERT_EQ(orris_renderer_set_option(renderer_, "SHOW_SHADOW", "true"), ORRIS_OK);
  frame_.time = 6000;
  std::vector<OrrisVertex> floor = {vertex(-8, 0, -8, 0, 0), vertex(-8, 0, 8, 0, 1),
                                    vertex(8, 0, 8, 1, 1), vertex(8, 0, -8, 1, 0)};
  OrrisBatch one = batch(ORRIS_KIND_SOLID, floor);
  one.passes = ORRIS_PASS_CAMERA;
  submit(one);
  EXPECT_EQ(middle(draw()), (Rgb{255, 255, 255})) << "the far plane";
  one.passes = ORRIS_PASS_SHADOW;
  submit(one);
  EXPECT_LT(middle(draw())[0], 250);
}

TEST_F(Geometry, may_lie_within_larger_vertices_and_have_indices) {
  struct Fat {
    float own[3];
    OrrisVertex orris;
    int more;
  };
  std::vector<Fat> vertices;
  for (const OrrisVertex& corner : quad(0, 0, 2, {10, 200, 30}))
    vertices.push_back({{}, corner, 0});
  OrrisBatch one = batch(ORRIS_KIND_SOLID, quad(0, 0, 1, {1, 1, 1}));
  one.vertex_buffer = buffer(vertices.data(), vertices.size() * sizeof(Fat));
  one.stride = sizeof(Fat);
  one.offset = offsetof(Fat, orris);
  submit(one);
  EXPECT_EQ(count(draw(), {10, 200, 30}), 24 * 24);
  const std::uint16_t indices[] = {99, 0, 1, 2, 2, 3, 0};
  one.primitive = ORRIS_TRIANGLES;
  one.index_buffer = buffer(indices, sizeof(indices));
  one.index_bytes = 2;
  one.index_offset = 2;
  one.count = 6;
  submit(one);
  EXPECT_EQ(count(draw(), {10, 200, 30}), 24 * 24);
}

TEST_F(Geometry, that_cannot_be_drawn_is_refused) {
  const OrrisBatch good = batch(ORRIS_KIND_SOLID, quad(0, 0, 2, {1, 2, 3}));
  std::vector<std::pair<OrrisBatch, const char*>> bad(12, {good, ""});
  bad[0].first.kind = ORRIS_KIND_COUNT, bad[0].second = "no OrrisKind";
  bad[1].first.vertex_buffer = 4711, bad[1].second = "no buffer";
  bad[2].first.count = 8, bad[2].second = "has 224 bytes";
  bad[3].first.count = 3, bad[3].second = "multiple of 4";
  bad[4].first.stride = 8, bad[4].second = "stride";
  bad[5].first.offset = ~std::uint64_t{0} - 8, bad[5].second = "224 bytes";
  bad[6].first.textures.normals = 4711, bad[6].second = "no texture";
  bad[7].first.origin[1] = std::numeric_limits<double>::infinity(), bad[7].second = "finite";
  bad[8].first.passes = 0, bad[8].second = "passes";
  bad[9].first.struct_size = 1, bad[9].second = "struct_size";
  bad[10].first.index_buffer = good.vertex_buffer, bad[10].second = "quads have none";
  bad[11].first.primitive = static_cast<OrrisPrimitive>(9), bad[11].second = "OrrisPrimitive";
  for (const auto& [one, words] : bad) {
    EXPECT_EQ(orris_renderer_submit(renderer_, &one), ORRIS_ERROR_ARGUMENT) << words;
    EXPECT_THAT(orris_last_error(), HasSubstr(words));
  }
  EXPECT_EQ(orris_renderer_submit(nullptr, &good), ORRIS_ERROR_HANDLE);
  EXPECT_EQ(orris_renderer_submit(renderer_, nullptr), ORRIS_ERROR_ARGUMENT);
  EXPECT_EQ(orris_renderer_set_draw_callback(renderer_, 1u << 31, nullptr, nullptr),
            ORRIS_ERROR_ARGUMENT);
  const std::string world = std::string(ORRIS_SOURCE_DIR) + "/worlds/lamps";
  EXPECT_EQ(orris_renderer_submit(make(request(testPack(), world.c_str())), &good),
            ORRIS_ERROR_ORDER);
  EXPECT_EQ(count(draw(), kBackground), kWidth * kHeight);
}

TEST_F(Geometry, facts_of_the_pack_say_what_vertices_must_hold) {
  OrrisPackFacts facts;
  facts.struct_size = sizeof(facts);
  ASSERT_EQ(orris_renderer_pack_facts(renderer_, &facts), ORRIS_OK);
  EXPECT_EQ(facts.separate_ao, 0);
  EXPECT_EQ(facts.casts_shadows, 1);
  EXPECT_EQ(facts.reads_normals, 0);
  const std::uint32_t before = facts.generation;
  ASSERT_EQ(orris_renderer_reload(renderer_), ORRIS_OK);
  ASSERT_EQ(orris_renderer_pack_facts(renderer_, &facts), ORRIS_OK);
  EXPECT_NE(facts.generation, before);
}

/// An engine that draws by itself while a program of the pack is bound.
struct Painter {
  OwnContext* own;
  GLuint array = 0, buffer = 0;
  int calls[2] = {0, 0};  ///< from the camera, from the light
  int position = -2;
  OrrisStatus status = ORRIS_OK, entered = ORRIS_OK;
  OrrisContext* context = nullptr;
  OrrisDraw* kept = nullptr;
  double at[3] = {};

  static void paint(OrrisDraw* draw, void* user) {
    auto& self = *static_cast<Painter*>(user);
    OrrisDrawFacts facts;
    facts.struct_size = sizeof(facts);
    self.status = orris_draw_facts(draw, &facts);
    ++self.calls[facts.shadow];
    orris_draw_attribute_location(draw, ORRIS_ATTRIBUTE_POSITION, &self.position);
    OWN_GL(*self.own, BindVertexArray)(self.array);
    OWN_GL(*self.own, BindBuffer)(GL_ARRAY_BUFFER, self.buffer);
    OrrisBatch values;
    orris_batch_init(&values, sizeof(values));
    std::copy_n(self.at, 3, values.origin);
    orris_draw_set(draw, &values);
    orris_draw_bind_vertices(draw, sizeof(OrrisVertex), 0);
    OWN_GL(*self.own, DrawArrays)(GL_TRIANGLE_FAN, 0, 4);
    self.entered = orris_context_destroy(self.context);
    self.kept = draw;
  }
};

class GeometryByCallback : public Geometry, public testing::WithParamInterface<bool> {
 protected:
  void SetUp() override {
    if (!own_) GTEST_SKIP() << "no OSMesa here";
    ASSERT_EQ(orris_context_adopt(OwnContext::resolve, &own_, &context_), ORRIS_OK);
    renderer_ = make(request(testPack()));
    frame_ = frameOf(renderer_);
    frame_.camera.yaw = 180;
    frame_.camera.fov = 90;
    for (float& part : frame_.fog_color) part = 0;
  }
  OwnContext own_{GetParam()};
};

TEST_P(GeometryByCallback, is_drawn_in_each_pass_of_its_kind) {
  const auto corners = quad(0, 0, 2, {10, 200, 30});
  Painter painter{&own_};
  painter.context = context_;
  std::copy_n(frame_.camera.position, 3, painter.at);
  OWN_GL(own_, CreateVertexArrays)(1, &painter.array);
  painter.buffer = buffer(corners.data(), corners.size() * sizeof(OrrisVertex));
  ASSERT_EQ(orris_renderer_set_draw_callback(renderer_, ORRIS_KIND_BIT(ORRIS_KIND_SOLID),
                                             Painter::paint, &painter),
            ORRIS_OK);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(count(draw(), {10, 200, 30}), 24 * 24);
  EXPECT_EQ(painter.calls[0], 3);
  EXPECT_EQ(painter.calls[1], 3);
  EXPECT_EQ(painter.status, ORRIS_OK);
  // Old GLSL has its position from a fixed array, but in a core context.
  EXPECT_EQ(painter.position >= 0, GetParam());
  EXPECT_EQ(painter.entered, ORRIS_ERROR_ORDER);
  EXPECT_EQ(orris_draw_bind_vertices(painter.kept, 56, 0), ORRIS_ERROR_HANDLE)
      << "the pass is over";
  EXPECT_EQ(OWN_GL(own_, GetError)(), unsigned{GL_NO_ERROR});
  ASSERT_EQ(orris_renderer_set_draw_callback(renderer_, 0, nullptr, nullptr), ORRIS_OK);
  EXPECT_EQ(count(draw(), kBackground), kWidth * kHeight);
  EXPECT_EQ(painter.calls[0], 3);
}

INSTANTIATE_TEST_SUITE_P(Profiles, GeometryByCallback, testing::Bool(), [](const auto& test) {
  return std::string(test.param ? "core" : "compatibility");
});

}  // namespace
}  // namespace orris_test
