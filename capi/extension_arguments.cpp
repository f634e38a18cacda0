// SPDX-License-Identifier: Apache-2.0
#include "extension_arguments.hpp"

#include <array>
#include <cstdio>

namespace abut::capi {

using Message = std::array<char, 200>;

abut_status refuse(abut_status status, const char* message) noexcept { return abut_set_last_error(status, message); }

abut_status refuse(abut_status status, const char* argument, double value, const char* expectation) noexcept {
  Message message{};
  std::snprintf(message.data(), message.size(), "%s is %.17g; %s", argument, value, expectation);
  return refuse(status, message.data());
}

abut_status refuse_null(const char* argument) noexcept {
  Message message{};
  std::snprintf(message.data(), message.size(), "%s is null", argument);
  return refuse(ABUT_NULL_ARGUMENT, message.data());
}

}  // namespace abut::capi
