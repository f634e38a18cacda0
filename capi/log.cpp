// SPDX-License-Identifier: Apache-2.0
#include "log.hpp"

#include "border.hpp"
#include "guard.hpp"
#include "options.hpp"

namespace abut::capi {
namespace {

// Both together, under the mutex. What nobody hears is not looked for: that asks for the level alone.
constinit std::mutex mutex;
constinit abut_log present_log = nullptr;
constinit void* present_context = nullptr;
constinit std::atomic<abut_log_level> most_heard{ABUT_LOG_NONE};

// A log that fails would hear of that, and so on.
constinit thread_local bool is_telling = false;

}  // namespace

bool is_heard(abut_log_level level) noexcept {
  return level != ABUT_LOG_NONE && level <= most_heard.load(std::memory_order_relaxed) && !is_telling;
}

void tell(abut_log_level level, std::string_view message) noexcept {
  if (!is_heard(level)) {
    return;
  }
  abut_log log = nullptr;
  void* context = nullptr;
  {
    const std::scoped_lock lock(mutex);
    log = present_log;
    context = present_context;
  }
  if (log == nullptr) {
    return;
  }
  const LastMessage kept = last_message_of_thread();
  LastMessage told{};
  std::copy_n(message.begin(), std::min(message.size(), told.size() - 1), told.begin());
  is_telling = true;
  log(context, level, told.data());
  is_telling = false;
  set_message(std::string_view(kept.data()));
}

abut_log_level level_of(abut_status status) noexcept {
  if (status == ABUT_OK) {
    return ABUT_LOG_NONE;
  }
  return status == ABUT_OUT_OF_MEMORY || status == ABUT_INTERNAL ? ABUT_LOG_ERROR : ABUT_LOG_WARNING;
}

}  // namespace abut::capi

using namespace abut::capi;

abut_status abut_set_log(abut_log log, void* context, abut_log_level most) {
  return guard([&] {
    const abut_status status = check_value({"most"}, "", most, ABUT_LOG_WARNING);
    if (status != ABUT_OK) {
      return status;
    }
    const std::scoped_lock lock(mutex);
    present_log = log;
    present_context = context;
    most_heard.store(log == nullptr ? abut_log_level{ABUT_LOG_NONE} : most, std::memory_order_relaxed);
    return status;
  });
}
