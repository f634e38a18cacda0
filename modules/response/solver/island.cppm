// SPDX-License-Identifier: Apache-2.0
// Groups of bodies that contacts join.
module;

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

export module abut.response:island;

export namespace abut::response {

struct Island {
  std::vector<std::uint32_t> bodies;    // in increasing order
  std::vector<std::uint32_t> contacts;  // in increasing order
};

// Islands of `count` bodies in the order of their first bodies. Contact k joins the bodies of joined[k], of which there
// is one at least. O(n log n).
[[nodiscard]] std::vector<Island> islands_of(std::size_t count, std::span<const std::vector<std::uint32_t>> joined);

}  // namespace abut::response
