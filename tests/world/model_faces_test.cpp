// Where the game puts the corners and the texture of a model's faces, worked out here from what each rule means.
#include <orris/world/resources/model_faces.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <orris/world/resources/model_json.h>
#include "resource_helpers.h"

namespace orris {
namespace {

using D = FaceDirection;

ElementTemplate box(glm::vec3 from, glm::vec3 to) {
  ElementTemplate element{from, to};
  for (auto& face : element.faces) face = FaceTemplate{.texture = "minecraft:block/a"};
  return element;
}

std::vector<ModelFace> facesOfBox(const ElementTemplate& element, ModelTurn turn = {}) {
  return facesOf({{element}, true}, turn);
}

const ModelFace& towards(const std::vector<ModelFace>& faces, D direction) {
  return *std::find_if(faces.begin(), faces.end(),
                       [&](const ModelFace& face) { return face.direction == direction; });
}

/// A point of the block after quarter turns: x lays up to the north, y turns the north to the east.
glm::vec3 turnedByHand(glm::vec3 p, int x, int y) {
  for (; x > 0; x -= 90) p = {p.x, p.z, 1 - p.y};
  for (; y > 0; y -= 90) p = {1 - p.z, p.y, p.x};
  return p;
}

/// Where a texture that covers the block lies on each side, seen from outside.
glm::vec2 uvOnBlock(D direction, glm::vec3 p) {
  switch (direction) {
    case D::Up:
      return {p.x, p.z};
    case D::Down:
      return {p.x, 1 - p.z};
    case D::North:
      return {1 - p.x, 1 - p.y};
    case D::South:
      return {p.x, 1 - p.y};
    case D::West:
      return {p.z, 1 - p.y};
    case D::East:
      break;
  }
  return {1 - p.z, 1 - p.y};
}

bool near(glm::vec3 a, glm::vec3 b) { return glm::distance(a, b) < 1e-5f; }

TEST(model_faces, a_face_without_uv_cuts_its_part_out_of_the_texture) {
  for (const ModelFace& face : facesOfBox(box({2, 4, 6}, {9, 11, 15}))) {
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_LT(glm::distance(face.uv[i], uvOnBlock(face.direction, face.corners[i])), 1e-5f)
          << int(face.direction);
  }
}

TEST(model_faces, corners_run_counter_clockwise_seen_from_outside) {
  for (int x = 0; x < 360; x += 90) {
    for (const ModelFace& face : facesOfBox(box({2, 4, 6}, {9, 11, 15}), {x, 90})) {
      const glm::vec3 out =
          glm::cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[1]);
      EXPECT_GT(glm::dot(out, face.normal), 0);
      EXPECT_EQ(face.normal, glm::vec3(normalOf(face.direction)));
    }
  }
}

TEST(model_faces, a_model_turns_about_x_first_and_then_about_y) {
  const auto plain = facesOfBox(box({0, 0, 0}, {16, 8, 4}));
  for (int x = 0; x < 360; x += 90) {
    for (int y = 0; y < 360; y += 90) {
      const auto turned = facesOfBox(box({0, 0, 0}, {16, 8, 4}), {x, y});
      for (std::size_t face = 0; face < plain.size(); ++face) {
        for (std::size_t i = 0; i < 4; ++i) {
          const glm::vec3 place = turnedByHand(plain[face].corners[i], x, y);
          const auto& corners = turned[face].corners;
          const auto found =
              std::find_if(corners.begin(), corners.end(),
                           [&](const glm::vec3& corner) { return near(corner, place); });
          ASSERT_NE(found, corners.end()) << x << " " << y;
          // The texture turns along.
          EXPECT_EQ(turned[face].uv[std::size_t(found - corners.begin())], plain[face].uv[i]);
        }
      }
    }
  }
}

TEST(model_faces, uvlock_leaves_the_texture_as_it_lies_on_the_block) {
  for (int x = 0; x < 360; x += 90) {
    for (int y = 0; y < 360; y += 90) {
      for (const ModelFace& face : facesOfBox(box({0, 0, 0}, {16, 8, 4}), {x, y, true})) {
        for (std::size_t i = 0; i < 4; ++i)
          EXPECT_LT(glm::distance(face.uv[i], uvOnBlock(face.direction, face.corners[i])), 1e-5f)
              << x << " " << y << " side " << int(face.direction);
      }
    }
  }
}

TEST(model_faces, the_neighbour_that_hides_a_face_turns_along) {
  ElementTemplate element = box({0, 0, 0}, {16, 16, 16});
  element.faces[int(D::Up)]->cull = D::Up;
  const auto faces = facesOfBox(element, {90, 90});
  EXPECT_EQ(towards(faces, D::East).cull, D::East);  // up to north, north to east
}

TEST(model_faces, a_rescaled_element_covers_the_block_again) {
  ElementTemplate element = box({0.8f, 0, 8}, {15.2f, 16, 8});
  element.turn = ElementTurn{{8, 8, 8}, {0, 45, 0}, true};
  const auto faces = facesOfBox(element);
  ASSERT_EQ(faces.size(), 2u);  // sides without area are left out
  for (const ModelFace& face : faces) {
    for (const glm::vec3& corner : face.corners) {
      EXPECT_NEAR(corner.x + corner.z, 1, 1e-6);  // from (0.05, 0.95) to (0.95, 0.05)
      EXPECT_NEAR(std::abs(corner.x - 0.5), 0.45, 1e-6);
    }
    EXPECT_NEAR(std::abs(face.normal.x), std::sqrt(0.5), 1e-6);
  }
  element.turn->rescale = false;
  const auto shorter = facesOfBox(element);
  for (const glm::vec3& corner : shorter[0].corners)
    EXPECT_NEAR(std::abs(corner.x - 0.5), 0.45 * std::sqrt(0.5), 1e-6);
}

TEST(model_faces, an_element_turns_about_its_own_origin) {
  ElementTemplate element = box({0, 0, 0}, {16, 2, 2});
  element.turn = ElementTurn{{0, 0, 0}, {0, 0, 22.5f}, false};
  const ModelFace face = towards(facesOfBox(element), D::North);
  const float c = std::cos(glm::radians(22.5f)), s = std::sin(glm::radians(22.5f));
  const auto has = [&](glm::vec3 place) {
    return std::any_of(face.corners.begin(), face.corners.end(),
                       [&](const glm::vec3& corner) { return near(corner, place); });
  };
  EXPECT_TRUE(has({0, 0, 0}));
  EXPECT_TRUE(has({c, s, 0}));
  EXPECT_TRUE(has({c - s / 8, s + c / 8, 0}));
}

TEST(model_faces, an_element_turns_about_x_then_y_then_z) {
  // The far end of a bar along z: up by the turn about -x, and to the west by that about z.
  ElementTemplate element = box({8, 8, 8}, {9, 9, 16});
  element.turn = ElementTurn{{8, 8, 8}, {-90, 0, 90}, false};
  bool found = false;
  for (const ModelFace& face : facesOfBox(element))
    for (const glm::vec3& corner : face.corners) found |= near(corner, {0, 0.5f, 0.5f});
  EXPECT_TRUE(found);
  element.turn = ElementTurn{{8, 8, 8}, {0, 90, -90}, false};  // y first: east, then down
  found = false;
  for (const ModelFace& face : facesOfBox(element))
    for (const glm::vec3& corner : face.corners) found |= near(corner, {0.5f, 0, 0.5f});
  EXPECT_TRUE(found);
}

TEST(model_faces, a_cube_that_turns_about_two_axes_is_stretched_along_each_of_its_own) {
  ElementTemplate element = box({0, 0, 0}, {16, 16, 16});
  element.turn = ElementTurn{{8, 8, 8}, {45, 45, 0}, true};
  // Its x axis turns into the diagonal of x and z, y and z into ones with parts 1/2, 1/2 and sqrt(1/2).
  const float root = std::sqrt(0.5f);
  for (const ModelFace& face : facesOfBox(element))
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(glm::distance(face.corners[i], face.corners[(i + 1) % 4]), 1 / root, 1e-5f);
}

TEST(model_faces, turns_of_elements_stand_by_axis_or_with_the_name_of_one) {
  const auto degreesOf = [](const std::string& rotation) {
    Diagnostics diagnostics;
    const auto model = parseModel({R"({"elements": [{"from": [0, 0, 0], "to": [16, 16, 16], "faces": {}, "rotation": {)" +
                                       rotation + "}}]}",
                                   "stick.json"},
                                  diagnostics);
    EXPECT_TRUE(diagnostics.empty()) << rotation;
    return model->elements->front().turn->degrees;
  };
  EXPECT_EQ(degreesOf(R"("x": 10, "y": -20, "z": 30.5)"), glm::vec3(10, -20, 30.5f));
  EXPECT_EQ(degreesOf(R"("z": 5)"), glm::vec3(0, 0, 5));
  EXPECT_EQ(degreesOf(R"("axis": "x", "angle": 45)"), glm::vec3(45, 0, 0));
  EXPECT_EQ(degreesOf(R"("axis": "y", "angle": -22.5)"), glm::vec3(0, -22.5f, 0));
  EXPECT_EQ(degreesOf(R"("axis": "z", "angle": 45)"), glm::vec3(0, 0, 45));
}

TEST(model_faces, rotation_of_a_face_turns_its_texture_clockwise) {
  ElementTemplate element = box({0, 0, 0}, {16, 16, 16});
  element.faces[int(D::South)]->uv = {{0, 0, 8, 16}};
  element.faces[int(D::South)]->rotation = 90;
  const ModelFace face = towards(facesOfBox(element), D::South);
  // The texture's bottom left comes to the top left.
  EXPECT_TRUE(near(face.corners[0], {0, 1, 1}));
  EXPECT_EQ(face.uv[0], glm::vec2(0, 1));
  EXPECT_EQ(face.uv[1], glm::vec2(0.5f, 1));
  EXPECT_EQ(face.uv[3], glm::vec2(0, 0));
  EXPECT_TRUE(near(glm::vec3(face.tangent), {0, -1, 0}));
}

TEST(model_faces, a_mirrored_texture_has_a_left_handed_frame) {
  ElementTemplate element = box({0, 0, 0}, {16, 16, 16});
  element.faces[int(D::South)]->uv = {{16, 0, 0, 16}};
  const ModelFace face = towards(facesOfBox(element), D::South);
  EXPECT_EQ(face.tangent, glm::vec4(-1, 0, 0, -1));
}

}  // namespace
}  // namespace orris
