// What a broad phase works on: numbered boxes, and the pairs of them that overlap.
module;
#include <cstdint>
#include <span>
#include <vector>
export module abut.broadphase.proxy;
import abut.math;

export namespace abut {

// Still boxes never pair with still ones.
enum class Mobility : std::uint8_t { moving, still };

// The numbers of two boxes; low is less than high.
struct ProxyPair {
  std::uint32_t low, high;

  friend constexpr bool operator==(const ProxyPair&, const ProxyPair&) = default;
};

// Writes pairs in order of (low, high). The boxes are numbered below `proxy_count`; `starts` is scratch.
void put_in_order(std::span<const ProxyPair> pairs, std::uint32_t proxy_count, std::vector<std::uint32_t>& starts,
                  std::vector<ProxyPair>& out);

}  // namespace abut
