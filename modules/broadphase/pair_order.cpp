module abut.broadphase.pair_order;
import abut.broadphase.proxy;
import abut.core.standard;

namespace abut {
namespace {

// Fewer are faster to compare than to count.
constexpr std::size_t least_to_count = 256;
constexpr std::uint32_t digit_bits = 8;
constexpr std::size_t digit_count = std::size_t{1} << digit_bits;

// A run of pairs of the same lower number; mostly a few.
void sort_run(std::span<ProxyPair> run) {
  constexpr std::size_t few = 24;
  if (run.size() > few) {
    std::sort(run.begin(), run.end(), [](const ProxyPair& a, const ProxyPair& b) { return a.high < b.high; });
    return;
  }
  for (std::size_t i = 1; i < run.size(); ++i) {
    const ProxyPair pair = run[i];
    std::size_t place = i;
    for (; place > 0 && pair.high < run[place - 1].high; --place) {
      run[place] = run[place - 1];
    }
    run[place] = pair;
  }
}

// Passes over the digits of the lower numbers bring those of one together.
void count_in_order(std::vector<ProxyPair>& pairs, std::vector<ProxyPair>& scratch) {
  scratch.resize(pairs.size());
  std::uint32_t all = 0;
  for (const ProxyPair& pair : pairs) {
    all |= pair.low;
  }
  for (std::uint32_t shift = 0; shift < 32 && (all >> shift) != 0; shift += digit_bits) {
    std::array<std::uint32_t, digit_count> starts{};
    const auto digit = [&](const ProxyPair& pair) { return (pair.low >> shift) & (digit_count - 1); };
    for (const ProxyPair& pair : pairs) {
      ++starts[digit(pair)];
    }
    std::uint32_t sum = 0;
    for (std::uint32_t& start : starts) {
      sum += start;
      start = sum - start;
    }
    for (const ProxyPair& pair : pairs) {
      scratch[starts[digit(pair)]++] = pair;
    }
    pairs.swap(scratch);
  }
  for (std::size_t begin = 0; begin < pairs.size();) {
    std::size_t end = begin + 1;
    while (end < pairs.size() && pairs[end].low == pairs[begin].low) {
      ++end;
    }
    sort_run(std::span(pairs).subspan(begin, end - begin));
    begin = end;
  }
}

}  // namespace

void put_in_order(std::vector<ProxyPair>& pairs, std::vector<ProxyPair>& scratch) {
  if (pairs.size() < least_to_count) {
    std::sort(pairs.begin(), pairs.end(), is_before);
    scratch.clear();
  } else {
    count_in_order(pairs, scratch);
  }
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  release_excess(scratch);
}

}  // namespace abut
