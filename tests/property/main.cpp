// SPDX-License-Identifier: Apache-2.0
// Runs the tests of a program, prints its table of worst errors, and writes it as CSV where the environment variable
// ABUT_PROPERTY_CSV says. A run of all tests fails where the list of known shortfalls says more or less than was found.
#include <gtest/gtest.h>

#include <cstdlib>

#include "record.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  int result = RUN_ALL_TESTS();
  property::record().print();
  const bool are_all =
      testing::GTEST_FLAG(filter) == "*" && testing::UnitTest::GetInstance()->skipped_test_count() == 0;
  if (are_all && !property::record().is_as_known(property::known_shortfalls())) result = EXIT_FAILURE;
  if (const char* path = std::getenv("ABUT_PROPERTY_CSV")) property::record().write_csv(path);
  return result;
}
