// SPDX-License-Identifier: Apache-2.0
// A shape from numbers that are known to be good: of a class, or of a form.
#pragma once
#include <cstdint>
#include <vector>

import abut.core;

namespace test {

template <class S>
auto made(const std::vector<double>& parameters, const std::vector<double>& reals = {},
          const std::vector<std::uint32_t>& indices = {}) {
  return S::make(parameters, reals, indices).value();
}

}  // namespace test
