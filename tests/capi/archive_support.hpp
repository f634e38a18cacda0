// SPDX-License-Identifier: Apache-2.0
// Universes as bytes and back, for tests.
#pragma once

#include <memory>

#include "support.hpp"

namespace abut_test {

struct DestroyUniverse {
  void operator()(abut_universe* universe) const { abut_universe_destroy(universe); }
};
using Owned = std::unique_ptr<abut_universe, DestroyUniverse>;

inline std::vector<std::uint8_t> saved(const abut_universe* universe) {
  std::size_t size = 0;
  require(abut_universe_save(universe, nullptr, 0, &size));
  std::vector<std::uint8_t> bytes(size);
  require(abut_universe_save(universe, bytes.data(), bytes.size(), &size));
  return bytes;
}

inline Owned loaded(const std::vector<std::uint8_t>& bytes) {
  abut_universe* made = nullptr;
  require(abut_universe_load(bytes.data(), bytes.size(), &made));
  return Owned(made);
}

}  // namespace abut_test
