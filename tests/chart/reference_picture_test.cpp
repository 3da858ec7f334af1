#include <orris/chart/measure/reference_picture.h>

#include <gmock/gmock.h>

#include <cmath>
#include <filesystem>
#include <limits>

#include <orris/chart/measure/display.h>

namespace orris {
namespace {

class ReferenceFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    path_ = testing::TempDir() + info->name() + ".exr";
  }
  void TearDown() override { std::filesystem::remove(path_); }
  std::string path_;
};

ImageF flatColour(float r, float g, float b) {
  ImageF image(4, 3, 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    image.pixels[i] = r;
    image.pixels[i + 1] = g;
    image.pixels[i + 2] = b;
  }
  return image;
}

TEST_F(ReferenceFile, KeepsBothHalves) {
  const ReferencePicture written{flatColour(2, 4, 6), flatColour(1, 3, 5), flatColour(3, 5, 7),
                                 true};
  Diagnostics diagnostics;
  ASSERT_TRUE(writeReference(path_, written, diagnostics));
  const auto read = readReference(path_, diagnostics);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->hasHalves);
  EXPECT_EQ(read->mean.pixels, written.mean.pixels);
  EXPECT_EQ(read->first.pixels, written.first.pixels);
  EXPECT_EQ(read->second.pixels, written.second.pixels);
  EXPECT_EQ(fingerprint(*read), fingerprint(written));
}

TEST_F(ReferenceFile, NineOtherChannelsAreNoHalves) {
  const ReferencePicture written{flatColour(9, 4, 6), flatColour(1, 3, 5), flatColour(3, 5, 7),
                                 true};
  Diagnostics diagnostics;
  ASSERT_TRUE(writeReference(path_, written, diagnostics));
  const auto read = readReference(path_, diagnostics);
  ASSERT_TRUE(read);
  EXPECT_FALSE(read->hasHalves);
  EXPECT_EQ(read->second.pixels, written.mean.pixels);
  EXPECT_EQ(noiseFloor(*read), 0);
}

TEST_F(ReferenceFile, WhatIsNoNumberIsRefused) {
  ImageF image = flatColour(1, 1, 1);
  image.pixels[4] = std::numeric_limits<float>::infinity();
  Diagnostics diagnostics;
  ASSERT_TRUE(writeImage(path_, image, diagnostics));
  EXPECT_FALSE(readReference(path_, diagnostics));
  ASSERT_EQ(diagnostics.size(), 1u);
  EXPECT_EQ(diagnostics[0].message, "holds a value that is no number");
}

TEST(ReferencePicture, NoiseFloorIsHalfTheDifferenceOfTheHalvesOverTheMean) {
  const ReferencePicture reference{flatColour(2, 2, 2), flatColour(1, 1, 1), flatColour(3, 3, 3),
                                   true};
  EXPECT_NEAR(noiseFloor(reference), 0.5, 1e-6);
}

TEST(Display, BrightReferencesAreBroughtBelowWhite) {
  const ImageF bright = flatColour(4, 4, 4), dim = flatColour(0.5f, 0.5f, 0.5f);
  EXPECT_NEAR(displayExposure({bright, bright, bright}), 0.25, 1e-6);
  EXPECT_EQ(displayExposure({dim, dim, dim}), 1);
  EXPECT_EQ(displayed(bright, 0.25f).pixels[0], 255);
  EXPECT_EQ(displayed(dim, 1).pixels[0], 188);  // sRGB of one half
  EXPECT_NEAR(displayedSimilarity(dim, dim, 1), 1, 1e-9);
}

TEST(Display, TooBrightIsRedAndTooDarkIsBlue) {
  const ImageF reference = flatColour(1, 1, 1);
  const auto pixel = [&](float value) {
    const Image8 image = signedDifference(flatColour(value, value, value), reference);
    return std::vector<int>(image.pixels.begin(), image.pixels.begin() + 3);
  };
  EXPECT_THAT(pixel(1), testing::ElementsAre(255, 255, 255));
  EXPECT_THAT(pixel(9), testing::ElementsAre(255, 0, 0));
  EXPECT_THAT(pixel(0), testing::ElementsAre(0, 0, 255));
  EXPECT_THAT(pixel(1.255f), testing::ElementsAre(255, 128, 128));
}

}  // namespace
}  // namespace orris
