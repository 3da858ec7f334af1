#include <orris/core/work_record.h>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace orris {
namespace {

TEST(work_record, another_process_reads_what_one_was_doing_when_it_died) {
  const WorkRecord record;
  if (const pid_t child = fork(); child == 0) {
    noteWork("compiling", "composite", "/composite.fsh");
    noteFrame(6);
    noteStep("composite1", "/composite1.fsh", true);
    raise(SIGKILL);
  } else {
    waitpid(child, nullptr, 0);
  }
  const WorkNote note = record.read();
  EXPECT_EQ(note.pieces, 2u);
  EXPECT_FALSE(note.idle);
  EXPECT_EQ(note.file, "/composite1.fsh");
  EXPECT_EQ(note.where(), "while drawing frame 7, in composite1");
}

TEST(work_record, words_say_how_sure_the_place_is) {
  const WorkRecord record;
  EXPECT_EQ(record.read().where(), "");
  noteWork("compiling", "composite", "/composite.fsh");
  EXPECT_EQ(record.read().where(), "while compiling composite");
  noteFrame(0);
  EXPECT_EQ(record.read().where(), "while drawing frame 1");
  EXPECT_EQ(record.read().file, "");
  noteStep("final", "/final.fsh", false);
  EXPECT_EQ(record.read().where(), "while drawing frame 1, in the passes up to final");
  noteIdle();
  EXPECT_TRUE(record.read().idle);
}

TEST(work_record, long_names_are_cut_and_none_is_kept_without_a_record) {
  {
    const WorkRecord record;
    noteWork("compiling", std::string(5000, 'n'), std::string(5000, 'f'));
    EXPECT_EQ(record.read().name, std::string(255, 'n'));
    EXPECT_EQ(record.read().file, std::string(255, 'f'));
    EXPECT_TRUE(workIsNoted());
  }
  EXPECT_FALSE(workIsNoted());
  noteWork("compiling", "composite", "");
  const WorkRecord record;
  EXPECT_EQ(record.read().pieces, 0u);
}

}  // namespace
}  // namespace orris
