// SPDX-License-Identifier: Apache-2.0
// The live target of contact problems.
#include <cstdio>
#include <cstdlib>

#include "problem.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string finding = response_fuzzing::finding_of({data, size});
  if (!finding.empty()) {
    std::fprintf(stderr, "finding: %s\n", finding.c_str());
    std::abort();
  }
  return 0;
}
