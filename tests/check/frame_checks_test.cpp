#include <orris/check/frame/frame_checks.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "frame_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(TargetUnread, a_buffer_that_no_file_names_is_reported_at_the_directive) {
  Files files = cleanPack();
  addProgram(files, "composite", fragmentStage("1,5", {"colortex0"}));
  EXPECT_THAT(
      messagesOf(checkTargetsRead, files),
      ElementsAre("target-unread /composite.fsh:2:1: warning: composite draws to colortex5, "
                  "but no program of the pack reads it | leave it out of the list, or read "
                  "it"));
}

TEST(TargetUnread, the_first_writer_is_reported_and_only_that) {
  Files files = cleanPack();
  addProgram(files, "deferred", fragmentStage("5", {"colortex0"}));
  addProgram(files, "composite", fragmentStage("1,5", {"colortex0"}));
  EXPECT_THAT(messagesOf(checkTargetsRead, files),
              ElementsAre(testing::HasSubstr("/deferred.fsh:2:1: warning: deferred draws to "
                                             "colortex5")));
}

TEST(TargetUnread, a_declaration_or_a_comment_does_not_read) {
  Files files = cleanPack();
  addProgram(files, "composite", fragmentStage("1,5", {"colortex0"}));
  files["/final.fsh"] += "uniform sampler2D colortex5; // colortex5: depth of field\n";
  EXPECT_THAT(messagesOf(checkTargetsRead, files), testing::SizeIs(1));
}

TEST(TargetUnread, any_branch_name_or_file_reads) {
  const std::vector<std::string> reads = {
      "#ifdef NEVER\nvec4 a() { return texture2D(colortex5, vec2(0)); }\n#endif\n",
      "#define SOURCE colortex5\n",
      "#ifdef NEVER\nvec4 a() { return texture2D(gaux2, vec2(0)); }\n#endif\n",
      "#ifdef NEVER\nvec4 a() { return imageLoad(colorimg5, ivec2(0)); }\n#endif\n",
      "#define BUFFER(n) colortex##n\n",
  };
  for (const std::string& read : reads) {
    Files files = cleanPack();
    addProgram(files, "composite", fragmentStage("1,5", {"colortex0"}));
    files["/world7/lib/unused.glsl"] = read;
    EXPECT_THAT(messagesOf(checkTargetsRead, files), IsEmpty()) << read;
  }
}

TEST(TargetUnread, shadow_colours_are_checked_when_a_directive_lists_them) {
  Files files = cleanPack();
  addProgram(files, "final", fragmentStage("", {"colortex1", "shadowcolor0"}));
  addProgram(files, "shadow", fragmentStage("", {"gtexture"}));
  EXPECT_THAT(messagesOf(checkTargetsRead, files), IsEmpty());
  addProgram(files, "shadow", fragmentStage("1,0", {"gtexture"}));
  EXPECT_THAT(messagesOf(checkTargetsRead, files),
              ElementsAre(testing::HasSubstr("/shadow.fsh:2:1: warning: shadow draws to "
                                             "shadowcolor1")));
}

TEST(TargetUnwritten, a_buffer_that_nobody_draws_to_is_reported_where_it_is_read) {
  Files files = cleanPack();
  addProgram(files, "composite", fragmentStage("1", {"colortex0", "colortex7"}));
  EXPECT_THAT(
      messagesOf(checkTargetsWritten, files),
      ElementsAre("target-unwritten /composite.fsh:8:18: warning: composite reads colortex7, "
                  "but no program of the pack draws to it | list it in a RENDERTARGETS "
                  "comment of the program that fills it"));
}

TEST(TargetUnwritten, a_list_in_a_file_that_no_program_reads_draws_nothing) {
  Files files = cleanPack();
  addProgram(files, "composite", fragmentStage("1", {"colortex0", "colortex7"}));
  files["/old/particles.glsl"] = "/* RENDERTARGETS: 7 */\n";
  EXPECT_THAT(messagesOf(checkTargetsWritten, files),
              ElementsAre(testing::HasSubstr("but no program of the pack draws to it")));
}

TEST(TargetUnwritten, a_read_before_the_only_writer_of_a_cleared_buffer_is_reported) {
  Files files = cleanPack();
  addProgram(files, "deferred", fragmentStage("0", {"colortex5"}));
  addProgram(files, "composite", fragmentStage("1,5", {"colortex0"}));
  EXPECT_THAT(
      messagesOf(checkTargetsWritten, files),
      ElementsAre("target-unwritten /deferred.fsh:6:18: warning: deferred reads colortex5, before "
                  "any program of the frame draws to it, and it is cleared at the start of each "
                  "frame | const bool colortex5Clear = false; keeps the image of the last frame"));
  files["/composite.fsh"] += "const bool colortex5Clear = false;\n";
  EXPECT_THAT(messagesOf(checkTargetsWritten, files), IsEmpty());
}

TEST(TargetUnwritten, an_image_store_fills_a_buffer) {
  Files files = cleanPack();
  const std::string store =
      "#version 430\nlayout(local_size_x = 8) in;\nlayout(rgba8) uniform image2D colorimg5;\n"
      "void main() { imageStore(colorimg5, ivec2(0), vec4(1.0)); }\n";
  addProgram(files, "deferred", fragmentStage("0", {"colortex5"}));
  addProgram(files, "composite", fragmentStage("1,5", {"colortex0"}));
  files["/prepare.csh"] = store;
  EXPECT_THAT(messagesOf(checkTargetsWritten, files), IsEmpty());
}

TEST(TargetUnwritten, a_writer_of_another_branch_program_or_folder_is_enough) {
  const std::string writer =
      "#version 330 compatibility\n#ifdef NEVER\n/* DRAWBUFFERS:05 */\n"
      "#endif\nvoid main() { gl_FragData[0] = vec4(1.0); }\n";
  Files files = cleanPack();
  addProgram(files, "deferred3", fragmentStage("0", {"colortex5"}));
  for (const std::string program : {"prepare", "deferred2", "world1/gbuffers_terrain"}) {
    Files more = files;
    addProgram(more, program, writer);
    EXPECT_THAT(messagesOf(checkTargetsWritten, more), IsEmpty()) << program;
  }
  addProgram(files, "deferred4", writer);
  EXPECT_THAT(messagesOf(checkTargetsWritten, files), testing::SizeIs(1));
}

TEST(TargetUnwritten, the_side_that_a_flip_leaves_behind_is_named) {
  Files files = cleanPack();
  addProgram(files, "deferred", fragmentStage("5", {"colortex0"}));
  addProgram(files, "composite", fragmentStage("1", {"colortex5"}));
  EXPECT_THAT(messagesOf(checkTargetsWritten, files), IsEmpty());
  files["/shaders.properties"] = "flip.deferred.colortex5=false\n";
  EXPECT_THAT(
      messagesOf(checkTargetsWritten, files),
      ElementsAre("target-unwritten /composite.fsh:6:18: warning: composite reads colortex5, whose "
                  "main side nothing has drawn to in this frame: deferred drew to the alt side | "
                  "flip.<program>.colortex5 decides which side the next program reads"));
}

TEST(TargetUnwritten, shared_code_is_right_when_one_of_its_programs_is) {
  Files files = cleanPack();
  files["/lib/sky.glsl"] =
      "uniform sampler2D colortex5;\nvec4 sky() { return texture2D(colortex5, vec2(0.5)); }\n";
  const std::string user =
      "#version 330 compatibility\n#include \"/lib/sky.glsl\"\n"
      "void main() { gl_FragData[0] = sky(); }\n";
  addProgram(files, "gbuffers_skybasic", user);
  addProgram(files, "deferred", fragmentStage("5", {"colortex0"}));
  EXPECT_THAT(messagesOf(checkTargetsWritten, files), testing::SizeIs(1));
  addProgram(files, "gbuffers_water", user);
  EXPECT_THAT(messagesOf(checkTargetsWritten, files), IsEmpty());
}

TEST(TargetUnwritten, custom_textures_images_and_the_atlas_are_no_targets) {
  Files files = cleanPack();
  files["/shaders.properties"] =
      "texture.composite.colortex7=tex.png\n"
      "iris.features.required=CUSTOM_IMAGES\n"
      "image.voxels=colortex9 RGBA RGBA8 UNSIGNED_BYTE false false 4 4\n";
  files["/tex.png"] = "not looked at";
  addProgram(files, "composite", fragmentStage("1", {"colortex7"}));
  addProgram(files, "gbuffers_terrain", fragmentStage("0", {"colortex2"}));
  files["/deferred.csh"] =
      "#version 430\nlayout(local_size_x = 8) in;\nlayout(rgba8) uniform image2D colorimg4;\n"
      "void main() { imageStore(colorimg4, ivec2(0), vec4(1.0)); }\n";
  addProgram(files, "composite2", fragmentStage("1", {"colortex4", "colortex1"}));
  EXPECT_THAT(messagesOf(checkTargetsWritten, files), IsEmpty());
}

}  // namespace
}  // namespace orris
