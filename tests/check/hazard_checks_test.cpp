#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <orris/check/frame/frame_checks.h>
#include <orris/check/frame/texture_checks.h>
#include "frame_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(TargetFeedback, a_geometry_program_that_samples_its_target_is_reported) {
  Files files = cleanPack();
  addProgram(files, "gbuffers_water", fragmentStage("0,5", {"colortex5"}));
  EXPECT_THAT(
      messagesOf(checkFeedback, files),
      ElementsAre("target-feedback /gbuffers_water.fsh:6:18: warning: gbuffers_water samples "
                  "colortex5 while it draws to it: geometry programs read and draw to the "
                  "same side, so what is read is undefined | copy colortex5 to another buffer "
                  "first, or draw to another one"));
}

TEST(TargetFeedback, own_texels_are_a_note_and_other_sides_are_fine) {
  Files files = cleanPack();
  addProgram(files, "gbuffers_water",
             fragmentStage("0,5", {}, "  c += texture2D(gaux2, gl_FragCoord.xy * 0.01);\n"));
  files["/gbuffers_water.fsh"].insert(files["/gbuffers_water.fsh"].find("void main"),
                                      "uniform sampler2D gaux2;\n");
  EXPECT_THAT(messagesOf(checkFeedback, files), ElementsAre(HasSubstr(": note: ")));
  addProgram(files, "gbuffers_water", fragmentStage("0,2", {"colortex2"}));  // the atlas
  addProgram(files, "deferred", fragmentStage("0,5", {"colortex5"}));        // reads the other side
  EXPECT_THAT(messagesOf(checkFeedback, files), IsEmpty());
}

TEST(TargetFeedback, a_texture_of_the_pack_stays_where_a_deferred_program_flips_the_buffer) {
  Files files = cleanPack();
  addProgram(files, "gbuffers_water", fragmentStage("0,5", {"colortex5"}));
  addProgram(files, "deferred", fragmentStage("0,5", {"colortex0"}));
  EXPECT_THAT(messagesOf(checkFeedback, files), testing::SizeIs(1));
  files["/shaders.properties"] = "texture.gbuffers.colortex5=a.png\n";
  files["/a.png"] = "";
  EXPECT_THAT(messagesOf(checkFeedback, files), IsEmpty());
}

TEST(TargetFeedback, another_texel_is_a_warning_whatever_else_the_program_asks_of_its_pixel) {
  const auto severityOf = [](const std::string& read) {
    Files files = cleanPack();
    addProgram(files, "gbuffers_water",
               fragmentStage("0,5", {}, "  vec2 uv = gl_FragCoord.xy * 0.5, other = vec2(0.5);\n  c += " +
                                            read + ";\n"));
    files["/gbuffers_water.fsh"].insert(files["/gbuffers_water.fsh"].find("void main"),
                                        "uniform sampler2D colortex5;\n");
    const auto messages = messagesOf(checkFeedback, files);
    return messages.size() == 1 ? messages[0].substr(messages[0].find(": ") + 2, 4) : "";
  };
  EXPECT_EQ(severityOf("texelFetch(colortex5, ivec2(gl_FragCoord.xy), 0)"), "note");
  EXPECT_EQ(severityOf("texture2D(colortex5, uv)"), "note");
  EXPECT_EQ(severityOf("texelFetch(colortex5, ivec2(3), 0)"), "warn");
  EXPECT_EQ(severityOf("texture2D(colortex5, other)"), "warn");
}

TEST(TargetUnbound, lower_targets_are_bound_in_fullscreen_programs_only) {
  Files files = cleanPack();
  addProgram(files, "gbuffers_water", fragmentStage("0", {"colortex2", "colortex4"}));
  EXPECT_THAT(messagesOf(checkUnboundTargets, files),
              ElementsAre("target-unbound /gbuffers_water.fsh:7:18: warning: gbuffers_water samples "
                          "colortex2, which Iris binds in fullscreen programs only: here it is the "
                          "texture of what is drawn, as gtexture is | write gtexture where the "
                          "texture is meant; the buffer itself can be read in deferred and "
                          "composite programs"));
  addProgram(files, "gbuffers_water",
             fragmentStage("0", {}, "  c += texelFetch(gdepth, ivec2(0), 0);\n"));
  files["/gbuffers_water.fsh"].insert(files["/gbuffers_water.fsh"].find("void main"),
                                      "uniform sampler2D gdepth;\n");
  EXPECT_THAT(messagesOf(checkUnboundTargets, files), ElementsAre(HasSubstr("samples gdepth")));
}

TEST(TargetUnbound, the_atlas_and_textures_of_the_pack_are_bound) {
  Files files = cleanPack();
  addProgram(files, "gbuffers_water", fragmentStage("0", {"gtexture", "gcolor", "colortex1"}));
  files["/shaders.properties"] = "texture.gbuffers.colortex1=a.png\n";
  files["/a.png"] = "";
  EXPECT_THAT(messagesOf(checkUnboundTargets, files), IsEmpty());
}

// The host renames gcolor, since old packs mean the atlas by it.
TEST(FramePasses, gcolor_of_a_fullscreen_program_is_colortex0) {
  for (const char* name : {"gcolor", "texture", "colortex0"}) {
    Files files = cleanPack();
    addProgram(files, "composite", fragmentStage("1", {}, "  c += texture2D(" + std::string(name) +
                                                              ", vec2(0.5));\n"));
    files["/composite.fsh"].insert(files["/composite.fsh"].find("void main"),
                                   "uniform sampler2D " + std::string(name) + ";\n");
    const ShaderPack pack = loadClean(files);
    Diagnostics diagnostics;
    const Schedule schedule = buildSchedule(pack, 64, 32, {}, diagnostics);
    bool reads = false;
    for (const FramePass& pass : framePasses(pack, schedule)) {
      for (const BufferUse& use : pass.uses)
        reads = reads || (pass.name == "composite" && use.isColor(false) && use.buffer.index == 0);
    }
    EXPECT_TRUE(reads) << name;
  }
}

TEST(TargetFeedback, a_function_that_main_does_not_reach_samples_nothing) {
  Files files = cleanPack();
  addProgram(files, "gbuffers_water", fragmentStage("0,5", {}));
  files["/gbuffers_water.fsh"].insert(
      files["/gbuffers_water.fsh"].find("void main"),
      "uniform sampler2D gaux2;\nvec4 a() { return texture2D(gaux2, vec2(0)); }\n"
      "vec4 b() { return a(); }\n");
  EXPECT_THAT(messagesOf(checkFeedback, files), IsEmpty());
}

Files packWithStore(const std::string& targets, const std::string& samplers) {
  Files files = cleanPack();
  addProgram(files, "deferred",
             "#version 430 compatibility\n/* RENDERTARGETS: " + targets +
                 " */\nlayout(rgba8) uniform image2D colorimg5;\nuniform sampler2D colortex0, "
                 "colortex5;\nvoid main() {\n  imageStore(colorimg5, ivec2(0), vec4(1.0));\n"
                 "  gl_FragData[0] = texture(" +
                 samplers + ", vec2(0.5));\n}\n");
  return files;
}

TEST(ImageStores, a_store_to_a_buffer_that_is_drawn_too_is_lost) {
  EXPECT_THAT(
      messagesOf(checkImageStores, packWithStore("5", "colortex0")),
      ElementsAre("target-store-lost /deferred.fsh:6:14: warning: deferred stores to "
                  "colorimg5 and draws to colortex5: the image is the side that the flip "
                  "after it leaves behind | store to a buffer that the program does not draw "
                  "to"));
  EXPECT_THAT(messagesOf(checkImageStores, packWithStore("0", "colortex0")), IsEmpty());
}

TEST(ImageStores, a_store_to_a_buffer_that_is_sampled_too_is_noted) {
  EXPECT_THAT(messagesOf(checkImageStores, packWithStore("0", "colortex5")),
              ElementsAre(HasSubstr("target-store-race /deferred.fsh:6:14: note: ")));
}

TEST(Mipmaps, a_level_that_nobody_makes_is_reported) {
  Files files = cleanPack();
  const std::string body = "  c += textureLod(colortex0, vec2(0.5), 2.0);\n";
  addProgram(files, "composite", fragmentStage("1", {"colortex0"}, body));
  EXPECT_THAT(messagesOf(checkMipmaps, files),
              ElementsAre("mipmap-missing /composite.fsh:7:19: warning: composite reads a higher "
                          "level of colortex0, but no program of the pack has its mipmaps made | "
                          "const bool colortex0MipmapEnabled = true; in the fragment stage"));
  files["/lib/settings.glsl"] =
      "#ifdef BLOOM\nconst bool gcolorMipmapEnabled = BLOOM_ON;\n#endif\n";
  EXPECT_THAT(messagesOf(checkMipmaps, files), IsEmpty());
}

TEST(Mipmaps, levels_that_nobody_reads_are_noted) {
  Files files = cleanPack();
  files["/composite.fsh"] += "const bool colortex4MipmapEnabled = true;\n";
  EXPECT_THAT(
      messagesOf(checkMipmaps, files),
      ElementsAre(HasSubstr("mipmap-unused /composite.fsh:2:1: note: composite has mipmaps of "
                            "colortex4 made, but no program reads it from here on")));
  addProgram(files, "composite3", fragmentStage("1", {"colortex4", "colortex1"}));
  EXPECT_THAT(messagesOf(checkMipmaps, files), IsEmpty());
}

TEST(OutputFormat, numbers_must_fit_the_format) {
  Files files = cleanPack();
  const std::string format = "/*\nconst int colortex5Format = RGB32UI;\n*/\n";
  addProgram(files, "composite",
             "#version 430 compatibility\n/* RENDERTARGETS: 1,5 */\n"
             "layout(location = 0) out vec4 a;\nlayout(location = 1) out vec4 b;\n"
             "void main() { a = b = vec4(1.0); }\n" +
                 format);
  EXPECT_THAT(
      messagesOf(checkOutputFormats, files),
      ElementsAre("output-format /composite.fsh:4:31: warning: composite writes vec4 to "
                  "colortex5, whose format is RGB32UI | declare the output as uvec4, or give "
                  "the buffer another format"));
  addProgram(files, "composite",
             "#version 430 compatibility\n/* RENDERTARGETS: 1,5 */\n"
             "layout(location = 0) out vec4 a;\nlayout(location = 1) out uvec4 b;\n"
             "void main() { a = vec4(1.0); b = uvec4(1); }\n" +
                 format);
  EXPECT_THAT(messagesOf(checkOutputFormats, files), IsEmpty());
}

TEST(FormatNarrow, a_component_that_the_format_has_not_is_reported) {
  Files files = cleanPack();
  addProgram(files, "composite",
             fragmentStage("1", {"colortex0"},
                           "  c.a = texture2D(colortex0, vec2(0.5)).a;\n"
                           "  c.rgb = texture2D(colortex0, vec2(0.5)).rga;\n") +
                 "/*\nconst int colortex0Format = RG16F;\n*/\n");
  EXPECT_THAT(messagesOf(checkComponents, files),
              ElementsAre("format-narrow /composite.fsh:7:19: warning: composite reads .a of "
                          "colortex0, but its format RG16F has 2 components: it is always 1 | give "
                          "the buffer a format with that component"));
  files["/lib/other.glsl"] = "/*\nconst int colortex0Format = RGBA16F;\n*/\n";
  EXPECT_THAT(messagesOf(checkComponents, files), ElementsAre(HasSubstr(": note: ")));
}

TEST(TexturesUsed, what_no_file_names_is_noted) {
  Files files = cleanPack();
  files["/tex.png"] = "not looked at";
  files["/lib/inactive.glsl"] = "#ifdef NEVER\nuniform sampler2D stars;\n#endif\n";
  files["/shaders.properties"] =
      "iris.features.required=CUSTOM_IMAGES\ncustomTexture.stars=tex.png\n"
      "texture.composite.moon=tex.png\nimage.cells=cellSampler RGBA RGBA8 UNSIGNED_BYTE false "
      "false "
      "4 4\n";
  const ShaderPack pack = loadClean(files);
  Diagnostics diagnostics;
  checkTexturesUsed(std::span(&pack, 1), diagnostics);
  std::vector<std::string> messages;
  for (const Diagnostic& d : diagnostics) messages.push_back(d.id + " " + d.message);
  EXPECT_THAT(messages, ElementsAre("texture-unused no program declares the sampler moon",
                                    "image-unused no program declares the image cells"));
}

}  // namespace
}  // namespace orris
