// SPDX-License-Identifier: Apache-2.0
module;

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

module abut.response;

namespace abut::response {

std::vector<Island> islands_of(std::size_t count, std::span<const std::vector<std::uint32_t>> joined) {
  std::vector<std::uint32_t> parents(count);
  std::iota(parents.begin(), parents.end(), 0U);
  // The least body of an island is its root, and paths are halved on the way there.
  const auto root = [&](std::uint32_t body) {
    while (parents[body] != body) body = parents[body] = parents[parents[body]];
    return body;
  };
  for (const std::vector<std::uint32_t>& bodies : joined) {
    for (const std::uint32_t body : bodies) {
      const std::uint32_t one = root(bodies.front()), other = root(body);
      parents[one < other ? other : one] = one < other ? one : other;
    }
  }
  std::vector<Island> islands;
  std::vector<std::uint32_t> places(count);
  for (std::uint32_t body = 0; body < count; ++body) {
    const std::uint32_t first = root(body);
    if (first == body) {
      places[body] = static_cast<std::uint32_t>(islands.size());
      islands.emplace_back();
    }
    islands[places[first]].bodies.push_back(body);
  }
  for (std::uint32_t k = 0; k < joined.size(); ++k) islands[places[root(joined[k].front())]].contacts.push_back(k);
  return islands;
}

}  // namespace abut::response
