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
  clear_message();
  try {
    return std::forward<Body>(body)();
  } catch (...) {
    return refuse_exception();
  }
}

}  // namespace abut::capi

#endif
