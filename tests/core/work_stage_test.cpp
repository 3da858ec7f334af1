#include <orris/core/work_stage.h>

#include <gtest/gtest.h>

#include <new>
#include <string>

namespace orris {
namespace {

// One test: the first failure of a process is kept.
TEST(work_stage, the_innermost_stage_that_an_exception_leaves_is_named) {
  { const WorkStage done("reading", "/done.fsh"); }
  EXPECT_EQ(WorkStage::whereFailed(), "");
  const std::string longName = "/" + std::string(2000, 'a');
  try {
    const WorkStage outer("checking", "/pack");
    const WorkStage inner("reading", longName);
    throw std::bad_alloc();
  } catch (const std::bad_alloc&) {
  }
  const std::string where = WorkStage::whereFailed();
  EXPECT_EQ(where.substr(0, 18), "while reading /aaa");
  EXPECT_LT(where.size(), 512u);
}

}  // namespace
}  // namespace orris
