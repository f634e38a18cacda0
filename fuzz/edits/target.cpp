// SPDX-License-Identifier: Apache-2.0
// The live target of edits of shapes.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "record.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> bytes;
  std::copy_n(data, size, std::back_inserter(bytes));
  edit_fuzzing::Counts counts;
  const std::string finding = edit_fuzzing::finding_of(bytes, counts);
  if (!finding.empty()) {
    std::fprintf(stderr, "finding: %s\n", finding.c_str());
    std::abort();
  }
  return 0;
}
