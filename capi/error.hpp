// SPDX-License-Identifier: Apache-2.0
// How a call fails: the message of this thread, and statuses for errors of the modules.
#ifndef ABUT_CAPI_ERROR_HPP
#define ABUT_CAPI_ERROR_HPP

#include "prelude.hpp"

import abut.core.standard;
import abut.core;

namespace abut::capi {

using LastMessage = std::array<char, 256>;
void set_message(std::string_view message) noexcept;
[[nodiscard]] LastMessage last_message_of_thread() noexcept;

// Sets the message and gives the status back.
[[gnu::cold]] abut_status refuse(abut_status status, std::string_view message) noexcept;
[[gnu::cold]] abut_status refuse(const Error& error) noexcept;

}  // namespace abut::capi

#endif
