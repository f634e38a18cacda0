// SPDX-License-Identifier: Apache-2.0
// Work that several threads share.
module;

#include <cstddef>
#include <cstdint>
#include <functional>

export module abut.response:jobs;

export namespace abut::response {

// Does job 0 to count - 1, each once, in any order. The first exception that a job throws comes out; then jobs may have
// been left out. A thread that cannot be had is done without.
void share_jobs(std::size_t count, std::uint32_t threads, const std::function<void(std::size_t)>& job);

}  // namespace abut::response
