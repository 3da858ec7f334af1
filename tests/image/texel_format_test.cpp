#include <orris/image/texel_format.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

namespace orris {
namespace {

TEST(FindFormat, ignores_case) {
  const TextureFormat* format = findFormat("r11f_g11F_b10f");
  ASSERT_NE(format, nullptr);
  EXPECT_EQ(format->name, "R11F_G11F_B10F");
  EXPECT_EQ(format->internalFormat, unsigned(GL_R11F_G11F_B10F));
}

TEST(FindFormat, refuses_unknown_and_partial_names) {
  for (const char* name : {"", "RGBA7", "RGBA8 ", "RGB", "R8U", "GL_RGBA8", "DEPTH_COMPONENT24"}) {
    EXPECT_EQ(findFormat(name), nullptr) << name;
  }
}

TEST(FindFormat, plain_rgba_is_eight_bit) {
  EXPECT_EQ(findFormat("RGBA")->internalFormat, unsigned(GL_RGBA8));
}

TEST(FindFormat, integer_formats_have_integer_transfer_formats) {
  for (const TextureFormat& format : textureFormats()) {
    const bool integerTransfer =
        format.pixelFormat == GL_RED_INTEGER || format.pixelFormat == GL_RG_INTEGER ||
        format.pixelFormat == GL_RGB_INTEGER || format.pixelFormat == GL_RGBA_INTEGER;
    EXPECT_EQ(format.isInteger(), integerTransfer) << format.name;
    EXPECT_EQ(componentsOf(format.pixelFormat), format.channels) << format.name;
  }
}

TEST(FindFormat, internal_format_finds_its_row) {
  EXPECT_EQ(findFormat(unsigned(GL_RG32UI))->name, "RG32UI");
  EXPECT_EQ(findFormat(unsigned(GL_DEPTH_COMPONENT24)), nullptr);
}

TEST(FindPixelFormat, knows_the_components) {
  EXPECT_EQ(findPixelFormat("bgra_integer"), unsigned(GL_BGRA_INTEGER));
  EXPECT_EQ(componentsOf(GL_BGRA_INTEGER), 4);
  EXPECT_EQ(componentsOf(GL_RED), 1);
  EXPECT_EQ(componentsOf(GL_FLOAT), 0);
  EXPECT_EQ(findPixelFormat("ALPHA"), std::nullopt);
}

TEST(FindPixelType, knows_the_bytes) {
  EXPECT_EQ(findPixelType("half_float"), std::pair(unsigned(GL_HALF_FLOAT), 2));
  EXPECT_EQ(findPixelType("UNSIGNED_INT_10_10_10_2"),
            std::pair(unsigned(GL_UNSIGNED_INT_10_10_10_2), 4));
  EXPECT_EQ(findPixelType("DOUBLE"), std::nullopt);
}

std::vector<std::string> splitCsv(const std::string& line) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

// Rows of the contract as column name -> cell.
std::vector<std::map<std::string, std::string>> readContract(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> header = splitCsv(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(file, line)) {
    const std::vector<std::string> cells = splitCsv(line);
    std::map<std::string, std::string> row;
    for (size_t i = 0; i < std::min(cells.size(), header.size()); ++i) row[header[i]] = cells[i];
    rows.push_back(std::move(row));
  }
  return rows;
}

TEST(Contract, every_row_is_known_with_its_facts) {
  const std::string path = ORRIS_SOURCE_DIR "/docs/contract/formats.csv";
  const std::map<std::string, FormatClass> classes = {{"unorm", FormatClass::Unorm},
                                                      {"snorm", FormatClass::Snorm},
                                                      {"float", FormatClass::Float},
                                                      {"int", FormatClass::Int},
                                                      {"uint", FormatClass::Uint}};
  size_t formats = 0;
  for (auto& row : readContract(path)) {
    const std::string& name = row["name"];
    if (row["kind"] == "internal") {
      ++formats;
      const TextureFormat* format = findFormat(name);
      ASSERT_NE(format, nullptr) << name;
      EXPECT_EQ(format->formatClass, classes.at(row["class"])) << name;
      EXPECT_EQ(format->channels, std::stoi(row["channels"])) << name;
      EXPECT_EQ(format->imageLoadStore, row["image_load_store"] == "yes") << name;
      EXPECT_EQ(format->pixelFormat, findPixelFormat(row["pixel_format"])) << name;
      const std::string& type = row["natural_pixel_type"];
      if (type.empty() || type == "UNSIGNED_INT_10F_11F_11F_REV" ||
          type == "UNSIGNED_INT_5_9_9_9_REV") {
        continue;  // no pixel type a pack can name
      }
      EXPECT_EQ(format->pixelType, findPixelType(type)->first) << name;
    } else if (row["kind"] == "pixel_format") {
      const auto found = findPixelFormat(name);
      ASSERT_NE(found, std::nullopt) << name;
      EXPECT_EQ(componentsOf(*found), std::stoi(row["channels"])) << name;
    } else if (row["kind"] == "pixel_type") {
      const auto found = findPixelType(name);
      ASSERT_NE(found, std::nullopt) << name;
      EXPECT_EQ(found->second, std::stoi(row["bits_or_bytes"])) << name;
    }
  }
  EXPECT_EQ(formats, textureFormats().size());
}

}  // namespace
}  // namespace orris
