// SPDX-License-Identifier: Apache-2.0
// libFuzzer's entry.
#include <cstdio>
#include <cstdlib>

#include "load.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string finding = load_fuzzing::finding_of({data, size});
  if (!finding.empty()) {
    std::fprintf(stderr, "finding: %s\n", finding.c_str());
    std::abort();
  }
  return 0;
}
