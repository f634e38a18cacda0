// SPDX-License-Identifier: Apache-2.0
// A build without threads: every call runs in the caller.
module abut.core.workers;
import abut.core.standard;

namespace abut {

struct Workers::Arena {};

Workers::Workers(std::uint32_t) : threads_(1) {}
Workers::Workers(Workers&&) noexcept = default;
Workers& Workers::operator=(Workers&&) noexcept = default;
Workers::~Workers() = default;

void Workers::run(std::size_t count, void (*call)(void* task, std::size_t i), void* task) const {
  for (std::size_t i = 0; i < count; ++i) {
    call(task, i);
  }
}

}  // namespace abut
