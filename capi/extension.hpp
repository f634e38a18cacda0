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
  void attach(std::string_view name) {
    const std::scoped_lock lock(mutex_);
    ++counts_.try_emplace(std::string(name), 0).first->second;
  }

  // False when none of that name is attached.
  [[nodiscard]] bool detach(std::string_view name) {
    const std::scoped_lock lock(mutex_);
    const auto found = counts_.find(name);
    if (found == counts_.end()) {
      return false;
    }
    if (--found->second == 0) {
      counts_.erase(found);
    }
    return true;
  }

  // By name.
  [[nodiscard]] std::vector<Plan::Extension> all() const {
    const std::scoped_lock lock(mutex_);
    std::vector<Plan::Extension> list;
    for (const auto& [name, count] : counts_) {
      list.push_back({name, count});
    }
    return list;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::uint64_t, std::less<>> counts_;
};

}  // namespace abut::capi

#endif
