// What every refusal of bad input looks like.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/cli/run_program.h"

namespace scanlit::test {

/// One line on stderr that begins with "error: " and holds `message`, nothing else, exit code 2.
inline void expect_refusal(const Outcome& outcome, const std::string& message) {
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(outcome.err.starts_with("error: ")) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_TRUE(outcome.err.ends_with('\n')) << outcome.err;
  EXPECT_NE(outcome.err.find(message), std::string::npos)
      << outcome.err << "does not say: " << message;
}

}  // namespace scanlit::test
