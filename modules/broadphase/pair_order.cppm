// SPDX-License-Identifier: Apache-2.0
// Pairs in order of their numbers.
export module abut.broadphase.pair_order;
import abut.broadphase.proxy;
import abut.core.standard;

export namespace abut {

[[nodiscard]] inline bool is_before(const ProxyPair& a, const ProxyPair& b) {
  return a.low < b.low || (a.low == b.low && a.high < b.high);
}

// Each pair once. In time that depends on the number of pairs alone, not on their numbers. Both lists keep their
// memory, and may swap it.
void put_in_order(std::vector<ProxyPair>& pairs, std::vector<ProxyPair>& scratch);

// In order of the highest bits of the lower numbers, which is as much as one pass can do: some thousand runs.
void gather_by_lower(std::vector<ProxyPair>& pairs, std::vector<ProxyPair>& scratch);

}  // namespace abut
