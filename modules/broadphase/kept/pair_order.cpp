// SPDX-License-Identifier: Apache-2.0
module abut.broadphase.kept.pair_order;
import abut.broadphase.proxy;
import abut.core.standard;

namespace abut {
namespace {

// Fewer are faster to compare than to count.
constexpr std::size_t least_to_count = 256;

// More need fewer passes; what a pass writes to in turn has to fit a cache.
constexpr std::uint32_t most_digit_bits = 11;
constexpr std::size_t most_digits = std::size_t{1} << most_digit_bits;

std::uint32_t bits_of_lower(std::span<const ProxyPair> pairs) {
  std::uint32_t all = 0;
  for (const ProxyPair& pair : pairs) {
    all |= pair.low;
  }
  return static_cast<std::uint32_t>(std::bit_width(all));
}

// By some bits of the lower number. Those in which they are the same stay in the order in which they come.
void count_by_digit(std::vector<ProxyPair>& pairs, std::vector<ProxyPair>& scratch, std::uint32_t shift,
                    std::uint32_t bits) {
  if (scratch.capacity() < pairs.size()) {
    scratch.reserve(pairs.capacity());
  }
  scratch.resize(pairs.size());
  std::array<std::uint32_t, most_digits> all_starts{};
  const std::span<std::uint32_t> starts = std::span(all_starts).first(std::size_t{1} << bits);
  const auto digit = [&](const ProxyPair& pair) { return (pair.low >> shift) & (starts.size() - 1); };
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
  const std::uint32_t bits = bits_of_lower(pairs);
  const std::uint32_t passes = (bits + most_digit_bits - 1) / most_digit_bits;
  for (std::uint32_t pass = 0; pass < passes; ++pass) {
    const std::uint32_t begin = pass * bits / passes, end = (pass + 1) * bits / passes;
    count_by_digit(pairs, scratch, begin, end - begin);
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
}

void gather_by_lower(std::vector<ProxyPair>& pairs, std::vector<ProxyPair>& scratch) {
  const std::uint32_t bits = bits_of_lower(pairs), digit = std::min(bits, most_digit_bits);
  count_by_digit(pairs, scratch, bits - digit, digit);
}

}  // namespace abut
