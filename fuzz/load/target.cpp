// SPDX-License-Identifier: Apache-2.0
// The live target of bytes of saved universes.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "load.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::uint8_t> body;
  std::copy_n(data, size, std::back_inserter(body));
  const std::string finding = load_fuzzing::finding_of(body);
  if (!finding.empty()) {
    std::fprintf(stderr, "finding: %s\n", finding.c_str());
    std::abort();
  }
  return 0;
}
