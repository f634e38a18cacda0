// SPDX-License-Identifier: Apache-2.0
// The object behind abut_response. It keeps out exceptions, and calls from within a step.
#ifndef ABUT_CAPI_RESPONSE_HANDLE_HPP
#define ABUT_CAPI_RESPONSE_HANDLE_HPP

#include <abut/response.h>

#include "core/check.hpp"
#include "extension_arguments.hpp"
#include "response/source.hpp"

#include <algorithm>
#include <cstddef>
#include <new>
#include <span>
#include <string_view>

import abut.response;

struct [[gsl::Pointer]] abut_response {
  abut::capi::ResponseAttachment attachment;
  abut::capi::UniversePointer universe;
  abut::response::Simulation simulation;
  abut_response_listener listener = nullptr;
  void* listener_context = nullptr;
  bool is_stepping = false;
};

namespace abut::capi {

template <class Action>
[[nodiscard]] abut_status guarded(const Action& action) noexcept {
  try {
    return action();
  } catch (const std::bad_alloc&) {
    return refuse(ABUT_OUT_OF_MEMORY, "there is not enough memory for the bodies of a response");
  } catch (...) {
    return refuse(ABUT_INTERNAL, "the bodies of a response could not be moved");
  }
}

// As guarded, but not from a callback of a step that is running.
template <class Action>
[[nodiscard]] abut_status guarded(abut_response* response, const Action& action) noexcept {
  if (response == nullptr) return refuse_null("response");
  if (response->is_stepping) return refuse(ABUT_BUSY, "response is in a step; a callback of it must not change it");
  return guarded([&] { return action(*response); });
}

/// As much of a text as fits, always terminated where there is room. Returns the bytes of the whole.
[[nodiscard]] inline std::size_t fill_text(std::string_view whole, char* text, std::size_t capacity) noexcept {
  // SAFETY: the caller answers for `capacity` bytes.
  ABUT_UNSAFE_BEGIN
  const std::span<char> out(text, capacity);
  ABUT_UNSAFE_END
  if (!out.empty()) {
    const std::size_t fits = std::min(whole.size(), out.size() - 1);
    std::ranges::copy(whole.substr(0, fits), out.begin());
    out[fits] = 0;
  }
  return whole.size() + 1;
}

}  // namespace abut::capi

#endif
