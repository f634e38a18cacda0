// Pairs in order of their numbers.
export module abut.broadphase.pair_order;
import abut.broadphase.proxy;
import abut.core.standard;

export namespace abut {

[[nodiscard]] inline bool is_before(const ProxyPair& a, const ProxyPair& b) {
  return a.low < b.low || (a.low == b.low && a.high < b.high);
}

// Each pair once. In time that depends on the number of pairs alone, not on their numbers. `scratch` keeps its memory.
void put_in_order(std::vector<ProxyPair>& pairs, std::vector<ProxyPair>& scratch);

// Gives back what a rare step needed and the usual ones do not.
template <class Element>
void release_excess(std::vector<Element>& list) {
  constexpr std::size_t least = 4096, most_excess = 8;
  if (list.capacity() > least && list.capacity() > most_excess * list.size()) {
    std::vector<Element> smaller;
    smaller.reserve(2 * list.size());
    smaller.assign(list.begin(), list.end());
    list.swap(smaller);
  }
}

}  // namespace abut
