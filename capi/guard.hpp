// SPDX-License-Identifier: Apache-2.0
// The firewall: nothing is thrown through an exported function.
#ifndef ABUT_CAPI_GUARD_HPP
#define ABUT_CAPI_GUARD_HPP

#include "prelude.hpp"

#include "error.hpp"

import abut.core;

namespace abut::capi {

// For use in a handler: which status the exception in flight stands for.
[[gnu::cold]] abut_status refuse_exception() noexcept;

template <class Body>
[[nodiscard]] inline abut_status guard(Body&& body) noexcept {
  try {
    return std::forward<Body>(body)();
  } catch (...) {
    return refuse_exception();
  }
}

// The same for an object that a defect makes unusable: what is left of it may break every promise.
template <class Body>
[[nodiscard]] inline abut_status guard(std::atomic<bool>& poisoned, Body&& body) noexcept {
  if (poisoned.load(std::memory_order_relaxed)) [[unlikely]] {
    return refuse(
        ABUT_INTERNAL,
        "a defect of abut, or lack of memory, ended a step half-way earlier; the universe can only be destroyed");
  }
  try {
    return std::forward<Body>(body)();
  } catch (...) {
    const abut_status status = refuse_exception();
    if (status == ABUT_INTERNAL) {
      poisoned.store(true, std::memory_order_relaxed);
    }
    return status;
  }
}

}  // namespace abut::capi

#endif
