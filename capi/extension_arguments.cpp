// SPDX-License-Identifier: Apache-2.0
#include "extension_arguments.hpp"

#include <array>
#include <cstdio>
#include <limits>

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

abut_status refuse_stale(const char* argument, std::uint32_t slot, std::uint32_t generation) noexcept {
  Message message{};
  std::snprintf(message.data(), message.size(), "%s is %s (slot %u, generation %u)", argument,
                slot == 0 ? "null" : "stale or of another universe", slot, generation);
  return refuse(ABUT_STALE_ID, message.data());
}

abut_status check_fits(const char* argument, std::size_t count, std::size_t size) noexcept {
  if (count <= static_cast<std::size_t>(std::numeric_limits<std::ptrdiff_t>::max()) / size) return ABUT_OK;
  Message message{};
  std::snprintf(message.data(), message.size(), "%s is %zu; that many elements do not fit into memory", argument,
                count);
  return refuse(ABUT_SIZE_OVERFLOW, message.data());
}

abut_status check_room(const char* argument, const void* room, std::size_t capacity, std::size_t size) noexcept {
  return room == nullptr && capacity != 0 ? refuse_null(argument) : check_fits("capacity", capacity, size);
}

}  // namespace abut::capi
