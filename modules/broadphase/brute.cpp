module;
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>
#include "../core/check.hpp"
module abut.broadphase.brute;
import abut.broadphase.proxy;
import abut.core;
import abut.math;

namespace abut {

std::size_t Brute::place_of(std::uint32_t proxy) const {
  const auto at = std::lower_bound(entries_.begin(), entries_.end(), proxy,
                                   [](const Entry& entry, std::uint32_t number) { return entry.proxy < number; });
  return static_cast<std::size_t>(at - entries_.begin());
}

void Brute::insert(std::uint32_t proxy, const CompactAabb& box, Mobility mobility, std::uint32_t group) {
  entries_.insert(entries_.begin() + static_cast<std::ptrdiff_t>(place_of(proxy)),
                  {box, proxy, group, mobility == Mobility::moving ? 1u : 0u});
}

void Brute::erase(std::uint32_t proxy) {
  const std::size_t place = place_of(proxy);
  ABUT_CHECK(place < entries_.size() && entries_[place].proxy == proxy);
  entries_.erase(entries_.begin() + static_cast<std::ptrdiff_t>(place));
}

void Brute::update(std::uint32_t proxy, const CompactAabb& box) {
  const std::size_t place = place_of(proxy);
  ABUT_CHECK(place < entries_.size() && entries_[place].proxy == proxy);
  entries_[place].box = box;
}

void Brute::find_pairs(std::vector<ProxyPair>& out) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Entry a = entries_[i];
    out.resize(count + entries_.size() - i);
    for (std::size_t j = i + 1; j < entries_.size(); ++j) {
      const Entry& b = entries_[j];
      // Always written, kept only if it counts: no branch to predict.
      out[count] = {a.proxy, b.proxy};
      count += std::size_t{a.box.overlaps(b.box)} & std::size_t{a.group != b.group} & (a.is_moving | b.is_moving);
    }
  }
  out.resize(count);
}

std::size_t Brute::bytes() const { return entries_.capacity() * sizeof(Entry); }

}  // namespace abut
