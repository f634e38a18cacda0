// SPDX-License-Identifier: Apache-2.0
// Pairs in order of their numbers.
export module abut.broadphase.kept.pair_order;
import abut.broadphase.proxy;
import abut.core.standard;

export namespace abut {

[[nodiscard]] inline bool is_before(const ProxyPair& a, const ProxyPair& b) {
  return a.low < b.low || (a.low == b.low && a.high < b.high);
}

// The first place from `from` on in a list in order, whose pair is not before another one; the end where there is none.
// What has `low` and `high` is a pair. O(log of how far the place is).
template <class Ordered>
[[nodiscard]] std::size_t place_from(std::size_t from, std::span<const Ordered> list, const ProxyPair& pair) {
  const auto is_earlier = [](const Ordered& its, const ProxyPair& other) {
    return is_before(ProxyPair{its.low, its.high}, other);
  };
  std::size_t step = 1;
  while (from + step <= list.size() && is_earlier(list[from + step - 1], pair)) {
    from += step;
    step *= 2;
  }
  const std::span<const Ordered> rest = list.subspan(from, std::min(step, list.size() - from));
  return from + static_cast<std::size_t>(std::lower_bound(rest.begin(), rest.end(), pair, is_earlier) - rest.begin());
}

// Each pair once. In time that depends on the number of pairs alone, not on their numbers. Both lists keep their
// memory, and may swap it.
void put_in_order(std::vector<ProxyPair>& pairs, std::vector<ProxyPair>& scratch);

// In order of the highest bits of the lower numbers, which is as much as one pass can do: some thousand runs.
void gather_by_lower(std::vector<ProxyPair>& pairs, std::vector<ProxyPair>& scratch);

}  // namespace abut
