// SPDX-License-Identifier: Apache-2.0
// What the log of the host hears.
#ifndef ABUT_CAPI_LOG_HPP
#define ABUT_CAPI_LOG_HPP

#include "prelude.hpp"

import abut.core.standard;

namespace abut::capi {

// Whether anybody hears of it.
[[nodiscard]] bool is_heard(abut_log_level level) noexcept;

// The message may be that of the last error: it stays as it is, whatever the log calls.
[[gnu::cold]] void tell(abut_log_level level, std::string_view message) noexcept;

// How grave a failure is.
[[nodiscard]] abut_log_level level_of(abut_status status) noexcept;

}  // namespace abut::capi

#endif
