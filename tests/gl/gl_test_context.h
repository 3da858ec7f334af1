// The context that the GL tests of this folder draw with.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include <orris/gl/context.h>

namespace orris::gl {

/// OSMesa where installed, else EGL; every test ends with a check that GL reported nothing.
class GlTest : public testing::Test {
 protected:
  void SetUp() override {
    Diagnostics diagnostics;
    context_ = createContext({}, diagnostics);
    ASSERT_NE(context_, nullptr) << diagnostics.front().message;
  }
  void TearDown() override {
    if (context_ == nullptr) return;
    EXPECT_THAT(context_->takeErrors(), testing::IsEmpty());
  }
  std::unique_ptr<Context> context_;
};

}  // namespace orris::gl
