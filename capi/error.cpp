// SPDX-License-Identifier: Apache-2.0
#include "error.hpp"

#include "log.hpp"

namespace abut::capi {
namespace {

// Without a constructor and a destructor, so that a host may unload the library while threads live.
constinit thread_local LastMessage last_message{};

constexpr std::array<const char*, 18> status_names{"ABUT_OK",
                                                   "ABUT_INVALID_ARGUMENT",
                                                   "ABUT_NULL_ARGUMENT",
                                                   "ABUT_NOT_FINITE",
                                                   "ABUT_OUT_OF_RANGE",
                                                   "ABUT_ZERO_VECTOR",
                                                   "ABUT_NOT_UNIT",
                                                   "ABUT_INDEX_OUT_OF_RANGE",
                                                   "ABUT_SIZE_OVERFLOW",
                                                   "ABUT_EMPTY",
                                                   "ABUT_STALE_ID",
                                                   "ABUT_WRONG_STRUCT_SIZE",
                                                   "ABUT_UNKNOWN_VALUE",
                                                   "ABUT_UNSUPPORTED",
                                                   "ABUT_NOT_CONVERGED",
                                                   "ABUT_OUT_OF_MEMORY",
                                                   "ABUT_INTERNAL",
                                                   "ABUT_BUSY"};
static_assert(ABUT_BUSY + 1 == status_names.size());

static_assert(static_cast<abut_status>(Errc::invalid_argument) == ABUT_INVALID_ARGUMENT);
static_assert(static_cast<abut_status>(Errc::null_argument) == ABUT_NULL_ARGUMENT);
static_assert(static_cast<abut_status>(Errc::not_finite) == ABUT_NOT_FINITE);
static_assert(static_cast<abut_status>(Errc::out_of_range) == ABUT_OUT_OF_RANGE);
static_assert(static_cast<abut_status>(Errc::zero_vector) == ABUT_ZERO_VECTOR);
static_assert(static_cast<abut_status>(Errc::not_unit) == ABUT_NOT_UNIT);
static_assert(static_cast<abut_status>(Errc::index_out_of_range) == ABUT_INDEX_OUT_OF_RANGE);
static_assert(static_cast<abut_status>(Errc::size_overflow) == ABUT_SIZE_OVERFLOW);
static_assert(static_cast<abut_status>(Errc::empty) == ABUT_EMPTY);
static_assert(static_cast<abut_status>(Errc::stale_id) == ABUT_STALE_ID);
static_assert(static_cast<abut_status>(Errc::wrong_struct_size) == ABUT_WRONG_STRUCT_SIZE);
static_assert(static_cast<abut_status>(Errc::unknown_value) == ABUT_UNKNOWN_VALUE);
static_assert(static_cast<abut_status>(Errc::unsupported) == ABUT_UNSUPPORTED);
static_assert(static_cast<abut_status>(Errc::not_converged) == ABUT_NOT_CONVERGED);
static_assert(static_cast<abut_status>(Errc::out_of_memory) == ABUT_OUT_OF_MEMORY);
static_assert(static_cast<abut_status>(Errc::internal) == ABUT_INTERNAL);
static_assert(static_cast<abut_status>(Errc::busy) == ABUT_BUSY);

}  // namespace

void set_message(std::string_view message) noexcept {
  // Cut at a whole UTF-8 character: continuation bytes start with the bits 10.
  std::size_t length = std::min(message.size(), last_message.size() - 1);
  if (length < message.size()) {
    while (length > 0 && (static_cast<unsigned char>(message[length]) & 0xC0u) == 0x80u) {
      --length;
    }
  }
  // The text may be the buffer itself: a caller that passes on the message of a call. No text may be no address.
  if (length > 0) {
    std::memmove(last_message.data(), message.data(), length);
  }
  last_message[length] = '\0';
}

abut_status refuse(abut_status status, std::string_view message) noexcept {
  set_message(message);
  if (const abut_log_level level = level_of(status); is_heard(level)) [[unlikely]] {
    tell(level, std::string_view(last_message.data()));
  }
  return status;
}

LastMessage last_message_of_thread() noexcept { return last_message; }

abut_status refuse(const Error& error) noexcept { return refuse(static_cast<abut_status>(error.code), error.message); }

}  // namespace abut::capi

using namespace abut::capi;

abut_status abut_set_last_error(abut_status status, const char* message) {
  return refuse(status, message == nullptr ? std::string_view() : std::string_view(message));
}

const char* abut_status_name(abut_status status) {
  const auto index = static_cast<std::size_t>(status);
  return status >= 0 && index < status_names.size() ? status_names[index] : "unknown";
}

const char* abut_last_error_message(void) { return last_message.data(); }
