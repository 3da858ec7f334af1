#include <orris/chart/gallery/gallery_page.h>

#include <gmock/gmock.h>

#include <array>

#include <orris/chart/page/embedded.h>
#include <orris/image/image_compare.h>

namespace orris {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

GalleryPicture plainPicture(std::uint8_t value) {
  GalleryPicture picture;
  picture.image = Image8(16, 16, 3);
  std::ranges::fill(picture.image.pixels, value);
  picture.milliseconds = 4;
  picture.passes = {{"deferred", 3, "deferred"}, {"final", 1, "final"}};
  picture.programs = {{"deferred", {{{"fragment", 1}, {"vertex", 2}}, {"/deferred.fsh", "/lib/a.glsl"}}},
                      {"final", {{{"fragment", 3}}, {"/final.fsh"}}}};
  return picture;
}

TEST(GalleryChange, equalPicturesAreEqual) {
  const PictureChange change = comparePictures(plainPicture(3), plainPicture(3), {});
  EXPECT_TRUE(change.equal);
  EXPECT_EQ(change.change + change.rmse + change.share, 0);
  for (const PassChange& pass : change.passes) EXPECT_EQ(pass.kind, Difference::Same);
}

/// Stripes of two colours.
GalleryPicture striped(std::array<std::uint8_t, 3> one, std::array<std::uint8_t, 3> other) {
  GalleryPicture picture = plainPicture(0);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) std::ranges::copy(x % 4 < 2 ? one : other, picture.image.at(x, y));
  return picture;
}

TEST(GalleryChange, ofGreyPicturesIsThatOfTheComparison) {
  const GalleryPicture before = striped({200, 200, 200}, {20, 20, 20}), after = striped({180, 180, 180}, {40, 40, 40});
  ImageF one(16, 16, 3), other = one;
  for (std::size_t i = 0; i < one.pixels.size(); ++i) {
    one.pixels[i] = float(after.image.pixels[i]) / 255;
    other.pixels[i] = float(before.image.pixels[i]) / 255;
  }
  Diagnostics none;
  const auto expected = compareImages(one, other, 0, none);
  const PictureChange change = comparePictures(before, after, {});
  EXPECT_FALSE(change.equal);
  EXPECT_NEAR(change.change, 1 - expected->ssim, 1e-6);
  EXPECT_NEAR(change.rmse, expected->rmse, 1e-6);
  EXPECT_GT(change.change, 0.01);
  EXPECT_EQ(change.share, 1);
}

TEST(GalleryChange, aChangeOfRedAloneCounts) {
  const GalleryPicture before = striped({200, 100, 60}, {20, 100, 60}), after = striped({20, 100, 60}, {20, 100, 60});
  EXPECT_GT(comparePictures(before, after, {}).change, 0.5);
}

TEST(GalleryChange, passesAreAddedRemovedAndChanged) {
  const GalleryPicture before = plainPicture(0);
  GalleryPicture after = plainPicture(0);
  after.passes = {{"deferred", 2, "deferred"}, {"composite", 5, "composite"}};
  after.programs["deferred"].stages["fragment"] = 9;
  const auto passes = comparePictures(before, after, {{"/lib/a.glsl", Difference::Changed}, {"/lib/b.glsl", Difference::Added}}).passes;
  ASSERT_EQ(passes.size(), 3u);
  EXPECT_EQ(passes[0].name + passes[1].name + passes[2].name, "deferredcompositefinal");
  EXPECT_EQ(passes[0].kind, Difference::Changed);
  EXPECT_EQ(passes[0].why, "fragment, by /lib/a.glsl");
  EXPECT_EQ(passes[0].before, 3);
  EXPECT_EQ(passes[0].after, 2);
  EXPECT_EQ(passes[1].kind, Difference::Added);
  EXPECT_EQ(passes[1].before, std::nullopt);
  EXPECT_EQ(passes[2].kind, Difference::Removed);
  EXPECT_EQ(passes[2].after, std::nullopt);
}

TEST(GalleryChange, anotherProgramForAPassIsAChange) {
  GalleryPicture after = plainPicture(0);
  after.passes[0].program = "";
  const auto passes = comparePictures(plainPicture(0), after, {}).passes;
  EXPECT_EQ(passes[0].kind, Difference::Changed);
  EXPECT_EQ(passes[0].why, "drawn by the host instead of deferred");
}

TEST(GalleryChange, filesThatDiffer) {
  const auto before = memorySource({{"/a", "1"}, {"/b", "2"}, {"/c", "3"}});
  const auto after = memorySource({{"/b", "2"}, {"/c", "4"}, {"/d", "5"}});
  EXPECT_THAT(changedFiles(*before, *after),
              ElementsAre(FileChange{"/a", Difference::Removed}, FileChange{"/c", Difference::Changed},
                          FileChange{"/d", Difference::Added}));
}

TEST(GalleryPicture, numbersGoThroughText) {
  const GalleryPicture picture = plainPicture(0);
  const auto read = parseGalleryNumbers(writeGalleryNumbers(picture));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->milliseconds, 4);
  EXPECT_EQ(read->passes, picture.passes);
  EXPECT_EQ(read->programs, picture.programs);
  for (const char* text : {"", "[]", "{}", R"({"milliseconds": "4"})", R"({"milliseconds":1,"passes":[[1,2]],"programs":{},"leftOut":[]})"})
    EXPECT_FALSE(parseGalleryNumbers(text)) << text;
}

/// Of three pictures, of which one changed and one could not be drawn.
Gallery threePictures() {
  Gallery gallery;
  gallery.title = "a <b> & \"c\"";
  gallery.against = true;
  for (const char* name : {"first", "changed", "lost <i>"}) gallery.entries.emplace_back().name = name;
  for (std::size_t i = 0; i < 2; ++i) {
    GalleryEntry& entry = gallery.entries[i];
    entry.before = {plainPicture(0), "old" + std::to_string(i), {}};
    entry.after = {plainPicture(i == 1 ? 90 : 0), "new" + std::to_string(i), {}};
    entry.change = PictureChange{i == 0, i * 0.5, 0, 0, {}};
  }
  gallery.entries[2].before = {plainPicture(0), "old", {}};
  gallery.entries[2].after.problems = {"/final.fsh:1:1: error: <script>alert(1)</script>"};
  return gallery;
}

TEST(GalleryPage, showsTheGapFirstThenTheLargestChange) {
  const std::string page = galleryPage(threePictures());
  const auto at = [&](const std::string& text) { return page.find(text); };
  ASSERT_NE(at("<h2 id=\"shot-2\">lost &lt;i&gt;</h2>"), std::string::npos);
  EXPECT_LT(at("<h2 id=\"shot-2\">"), at("<h2 id=\"shot-1\">"));
  EXPECT_LT(at("<h2 id=\"shot-1\">"), at("<h2 id=\"shot-0\">"));
  EXPECT_THAT(page, HasSubstr("not drawn"));
  EXPECT_THAT(page, HasSubstr("1 of 3 pictures are equal"));
  EXPECT_THAT(page, HasSubstr("alt=\"changed, after\""));
}

TEST(GalleryPage, aStrangersTextIsNoMarkup) {
  const std::string page = galleryPage(threePictures());
  EXPECT_THAT(page, HasSubstr("<title>a &lt;b&gt; &amp; &quot;c&quot;</title>"));
  EXPECT_THAT(page, HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("alert(1)</script>")));
  EXPECT_EQ(htmlText("'\x1b'\n\xff"), "&#39;\\x1b&#39;\n\xef\xbf\xbd");
}

TEST(GalleryPage, needsNothingBesideIt) {
  const std::string page = galleryPage(threePictures());
  EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data:"));
  for (const char* outside : {"http:", "https:", "src=\"/", "href=", "@import", "url("})
    EXPECT_THAT(page, Not(HasSubstr(outside)));
  EXPECT_THAT(page, HasSubstr(dataUri("image/png", "new1")));
}

TEST(GalleryPage, withoutAnotherRevisionTheOrderIsThatOfTheSet) {
  Gallery gallery = threePictures();
  gallery.against = false;
  for (GalleryEntry& entry : gallery.entries) entry.before = {}, entry.change.reset();
  const std::string page = galleryPage(gallery);
  EXPECT_LT(page.find("<h2 id=\"shot-0\">"), page.find("<h2 id=\"shot-2\">"));
  EXPECT_THAT(page, Not(HasSubstr("ms before")));
}

}  // namespace
}  // namespace orris
