// What a broad phase works on: numbered boxes, and the pairs of them that overlap.
module;
#include <cstdint>
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

// Puts pairs in order of (low, high). The boxes are numbered below `proxy_count`; `scratch` and
// `starts` keep their memory from call to call.
void put_in_order(std::vector<ProxyPair>& pairs, std::uint32_t proxy_count, std::vector<ProxyPair>& scratch,
                  std::vector<std::uint32_t>& starts);

}  // namespace abut
