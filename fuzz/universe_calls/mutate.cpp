// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "call.hpp"

namespace universe_calls {

void mutate(Sequence& sequence, std::uint64_t seed, std::size_t most) {
  Random random(seed);
  std::vector<Call>& calls = sequence.calls;
  const auto place = [&](std::size_t limit) {
    return calls.begin() + static_cast<std::ptrdiff_t>(random.below(limit));
  };
  const auto any_call = [&] {
    Call call;
    std::ranges::generate(call.bytes, [&] { return static_cast<std::uint8_t>(random.bits() & 0xff); });
    return call;
  };
  const std::size_t choice = calls.empty() ? 0 : random.below(8);
  if (choice == 0) {
    calls.insert(place(calls.size() + 1), any_call());
  } else if (choice == 1) {
    calls.erase(place(calls.size()));
  } else if (choice == 2) {
    const Call repeated = *place(calls.size());
    calls.insert(place(calls.size() + 1), repeated);
  } else if (choice == 3) {
    std::iter_swap(place(calls.size()), place(calls.size()));
  } else if (choice == 4) {
    // A stretch of calls once more elsewhere.
    const std::size_t begin = random.below(calls.size());
    const std::size_t end = std::min(calls.size(), begin + 1 + random.below(8));
    const std::vector<Call> stretch(calls.begin() + static_cast<std::ptrdiff_t>(begin),
                                    calls.begin() + static_cast<std::ptrdiff_t>(end));
    calls.insert(place(calls.size() + 1), stretch.begin(), stretch.end());
  } else if (choice == 5) {
    sequence.setup.bytes.at(random.below(call_size)) = static_cast<std::uint8_t>(random.bits() & 0xff);
  } else {
    place(calls.size())->bytes.at(random.below(call_size)) = static_cast<std::uint8_t>(random.bits() & 0xff);
  }
  calls.resize(std::min({calls.size(), most, most_calls}));
}

Sequence spliced(const Sequence& one, const Sequence& other, std::uint64_t seed) {
  Random random(seed);
  Sequence out{one.setup, one.calls};
  out.calls.resize(random.below(one.calls.size() + 1));
  const std::size_t from = random.below(other.calls.size() + 1);
  out.calls.insert(out.calls.end(), other.calls.begin() + static_cast<std::ptrdiff_t>(from), other.calls.end());
  out.calls.resize(std::min(out.calls.size(), most_calls));
  return out;
}

}  // namespace universe_calls
