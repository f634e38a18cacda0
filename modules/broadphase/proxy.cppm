// SPDX-License-Identifier: Apache-2.0
// What a broad phase works on: numbered boxes, and the pairs of them that overlap.
export module abut.broadphase.proxy;
import abut.core.standard;

export namespace abut {

// Still boxes never pair with still ones.
enum class Mobility : std::uint8_t { moving, still };

// The numbers of two boxes; low is less than high.
struct ProxyPair {
  std::uint32_t low, high;

  friend constexpr bool operator==(const ProxyPair&, const ProxyPair&) = default;
};

}  // namespace abut
