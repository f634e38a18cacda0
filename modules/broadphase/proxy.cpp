module;
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>
module abut.broadphase.proxy;

namespace abut {

// One counting pass brings pairs of the same lower number together; the few of each are then
// inserted one by one. Linear for bounded numbers of neighbours.
void put_in_order(std::span<const ProxyPair> pairs, std::uint32_t proxy_count, std::vector<std::uint32_t>& starts,
                  std::vector<ProxyPair>& out) {
  starts.assign(std::size_t{proxy_count} + 1, 0);
  for (const ProxyPair& pair : pairs) {
    ++starts[pair.low + 1];
  }
  for (std::size_t i = 1; i < starts.size(); ++i) {
    starts[i] += starts[i - 1];
  }
  out.resize(pairs.size());
  for (const ProxyPair& pair : pairs) {
    out[starts[pair.low]++] = pair;
  }
  // starts[i] has become the end of the pairs of i.
  std::uint32_t begin = 0;
  for (std::size_t i = 0; i < proxy_count; ++i) {
    const std::uint32_t end = starts[i];
    if (end - begin > 1) {
      const std::span<ProxyPair> equal = std::span(out).subspan(begin, end - begin);
      std::sort(equal.begin(), equal.end(), [](const ProxyPair& a, const ProxyPair& b) { return a.high < b.high; });
    }
    begin = end;
  }
}

}  // namespace abut
