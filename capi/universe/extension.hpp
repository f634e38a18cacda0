// SPDX-License-Identifier: Apache-2.0
// Which extension libraries stand on a universe.
#ifndef ABUT_CAPI_EXTENSION_HPP
#define ABUT_CAPI_EXTENSION_HPP

#include "prelude.hpp"

import abut.core.standard;
import abut.universe;

namespace abut::capi {

// Counts by name. Safe from many threads at once.
class Extensions {
 public:
  void attach(std::string_view name);

  // False when none of that name is attached.
  [[nodiscard]] bool detach(std::string_view name);

  // By name.
  [[nodiscard]] std::vector<Plan::Extension> all() const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::uint64_t, std::less<>> counts_;
};

}  // namespace abut::capi

#endif
