#include <orris/check/graph/pass_graph.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "frame_fixture.h"

namespace orris {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Source = GraphRead::Source;

PassGraph graphOf(const Files& files) {
  const ShaderPack pack = loadClean(files);
  Diagnostics diagnostics;
  return passGraph(pack, buildSchedule(pack, 64, 32, {}, diagnostics));
}

const GraphPass& passOf(const PassGraph& graph, const std::string& name) {
  const auto found = std::find_if(graph.passes.begin(), graph.passes.end(),
                                  [&](const GraphPass& pass) { return pass.name == name; });
  EXPECT_NE(found, graph.passes.end()) << name;
  return *found;
}

std::vector<std::string> names(const PassGraph& graph) {
  std::vector<std::string> result;
  for (const GraphPass& pass : graph.passes) result.push_back(pass.name);
  return result;
}

/// Terrain fills colortex0, deferred darkens it with the last frame's light, composite blurs.
Files smallPack() {
  Files files;
  addProgram(files, "gbuffers_terrain", fragmentStage("0", {"gtexture", "colortex2"}));
  addProgram(files, "gbuffers_entities", fragmentStage("0", {"gtexture"}));
  addProgram(files, "deferred",
             fragmentStage("0,5", {"colortex0", "colortex5"}, "gl_FragData[1] = c;\n") +
                 "/*\nconst bool colortex5Clear = false;\nconst int colortex5Format = RG16F; */\n");
  addProgram(files, "composite",
             fragmentStage("0", {"colortex0", "depthtex1"}) +
                 "const bool colortex0MipmapEnabled = true;\n");
  addProgram(files, "final", fragmentStage("", {"colortex0"}));
  return files;
}

TEST(PassGraph, passes_come_in_frame_order_with_undrawn_geometry_beside_the_drawn) {
  EXPECT_THAT(names(graphOf(smallPack())),
              ElementsAre("gbuffers_skybasic", "gbuffers_skytextured", "gbuffers_terrain",
                          "gbuffers_entities", "copy_depthtex1", "deferred",
                          "gbuffers_terrain (translucent)", "composite", "final"));
}

TEST(PassGraph, reads_know_their_side_and_who_drew_it) {
  const PassGraph graph = graphOf(smallPack());
  const auto& deferred = passOf(graph, "deferred");
  ASSERT_EQ(deferred.reads.size(), 2u);
  EXPECT_EQ(deferred.reads[0].buffer, "colortex0");
  EXPECT_FALSE(deferred.reads[0].alt);
  EXPECT_THAT(deferred.reads[0].from, ElementsAre("gbuffers_skybasic", "gbuffers_skytextured",
                                                  "gbuffers_terrain", "gbuffers_entities"));
  EXPECT_EQ(deferred.reads[1].source, Source::History);
  EXPECT_THAT(deferred.reads[1].from, ElementsAre("deferred"));
  EXPECT_THAT(deferred.flips, ElementsAre("colortex0", "colortex5"));
  const auto& composite = passOf(graph, "composite");
  ASSERT_EQ(composite.reads.size(), 2u);
  EXPECT_TRUE(composite.reads[0].alt);
  EXPECT_TRUE(composite.reads[0].mipmaps);
  EXPECT_THAT(composite.reads[0].from, ElementsAre("deferred", "gbuffers_terrain (translucent)"));
  EXPECT_EQ(composite.reads[1].source, Source::Host);
  EXPECT_THAT(passOf(graph, "final").reads[0].from, ElementsAre("composite"));
}

TEST(PassGraph, geometry_reads_no_colortex_below_4) {
  EXPECT_THAT(passOf(graphOf(smallPack()), "gbuffers_terrain").reads, IsEmpty());
}

TEST(PassGraph, undrawn_and_built_in_programs_are_marked) {
  const PassGraph graph = graphOf(smallPack());
  EXPECT_FALSE(passOf(graph, "gbuffers_entities").drawn);
  EXPECT_EQ(passOf(graph, "gbuffers_skybasic").file, "");
  EXPECT_EQ(passOf(graph, "gbuffers_terrain").file, "/gbuffers_terrain.fsh");
}

TEST(PassGraph, computes_tell_images_and_groups) {
  Files files = smallPack();
  files["/composite_a.csh"] = "#version 430\nvoid main() {}\n";
  files["/composite.csh"] =
      "#version 430\nlayout(local_size_x = 16, local_size_y = 16) in;\n"
      "const vec2 workGroupsRender = vec2(0.5, 0.5);\nlayout(rgba8) uniform image2D colorimg5;\n"
      "void main() { imageStore(colorimg5, ivec2(0), vec4(1.0)); }\n";
  const auto graph = graphOf(files);
  const auto& compute = passOf(graph, "composite (compute)");
  EXPECT_EQ(compute.title, "composite");
  ASSERT_EQ(compute.images.size(), 1u);
  EXPECT_EQ(compute.images[0].buffer, "colortex5");
  EXPECT_TRUE(compute.images[0].stores);
  EXPECT_FALSE(compute.images[0].loads);
  ASSERT_EQ(compute.computes.size(), 2u);
  EXPECT_THAT(compute.computes[0].groups, ElementsAre(2, 1, 1));
}

TEST(PassGraph, markdown_tables_list_buffers_and_programs) {
  PassGraph graph = graphOf(smallPack());
  graph.pack = "small|pack";
  const std::string text = toMarkdown(graph);
  EXPECT_THAT(text, HasSubstr("# small\\|pack, /\n\nWindow 64x32.\n\n## Buffers\n\n"
                              "| buffer    | format | size   | cleared to | drawn by"));
  EXPECT_THAT(text, HasSubstr("| colortex5 | RG16F  | window | kept       | deferred "));
  EXPECT_THAT(text, HasSubstr("colortex0, colortex5 (last frame)"));
  EXPECT_THAT(text, HasSubstr("| colortex0 (mipmaps), depthtex1 "));
  EXPECT_THAT(text, HasSubstr("drawn where a world has it"));
}

TEST(PassGraph, dot_joins_alike_geometry_and_dashes_history) {
  const std::string dot = toDot(graphOf(smallPack()));
  EXPECT_THAT(dot, HasSubstr("<B>gbuffers_skybasic, gbuffers_skytextured, gbuffers_terrain<BR/>"
                             "gbuffers_entities</B>"));
  EXPECT_THAT(dot, HasSubstr("p1 -> p1 [label=\"colortex5\", color=\"#00838f\", "
                             "fontcolor=\"#00838f\", style=dashed, constraint=false];"));
  EXPECT_THAT(dot, HasSubstr("p3 -> p4 [label=\"colortex0\""));
}

TEST(PassGraph, dot_escapes_what_the_pack_names) {
  PassGraph graph = graphOf(smallPack());
  graph.pack = "<TABLE>&\"";
  graph.passes[0].textures = {"a<b>"};
  const std::string dot = toDot(graph);
  EXPECT_THAT(dot, HasSubstr("<B>&lt;TABLE&gt;&amp;&quot;</B>"));
  EXPECT_THAT(dot, HasSubstr("textures a&lt;b&gt;"));
}

TEST(PassGraph, json_has_a_version) {
  EXPECT_THAT(toJsonText(graphOf(smallPack())), HasSubstr("\"version\": 1"));
}

}  // namespace
}  // namespace orris
