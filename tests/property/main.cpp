// Runs the tests of a program, prints its table of worst errors, and writes it as CSV where the environment variable
// ABUT_PROPERTY_CSV says.
#include <gtest/gtest.h>

#include <cstdlib>

#include "record.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  const int result = RUN_ALL_TESTS();
  property::record().print();
  if (const char* path = std::getenv("ABUT_PROPERTY_CSV")) property::record().write_csv(path);
  return result;
}
