// SPDX-License-Identifier: Apache-2.0
// The places of things that are large to move, put in an order by numbers of theirs.
export module abut.narrow.manifold.places_in_order;
import abut.core.standard;
import abut.math;

export namespace abut {

// Numbers that come in the order of finite reals; both zeros are one.
[[nodiscard]] inline std::uint64_t bits_in_order(Real value) {
  const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  return (bits & sign) != 0 ? ~bits : bits | sign;
}

// Writes 0 to places.size() - 1 in the order of value_of(place). Equal ones follow is_before(place, other place). There
// are `most` at most. How many values are less is counted, and no branch depends on it: sorting branches on every
// comparison, and the processor guesses half of these wrong. False, with nothing to keep, where a value is no number.
template <std::size_t most, class ValueOf, class IsBefore>
[[nodiscard]] inline bool rank_few(std::span<std::uint32_t> places, const ValueOf& value_of,
                                   const IsBefore& is_before) {
  static_assert(most % 4 == 0);
  [[clang::uninitialized]] std::array<Lanes, most / 4> values;
  const std::size_t groups = (places.size() + 3) / 4;
  for (std::uint32_t i = 0; i < 4 * groups; ++i) {
    values[i / 4][i % 4] = i < places.size() ? value_of(i) : infinity;
  }
  [[clang::uninitialized]] std::array<std::uint16_t, most> equal;  // how many of a rank there are so far
  for (std::uint16_t& count : std::span(equal).first(places.size())) {
    count = 0;
  }
  for (std::uint32_t first = 0; first < places.size(); first += 4) {
    const Lanes& own = values[first / 4];
    LaneNumbers less{}, less_than_second{}, less_than_third{}, less_than_fourth{};
    for (const Lanes& others : std::span(values).first(groups)) {
      less -= others < own.xxxx;
      less_than_second -= others < own.yyyy;
      less_than_third -= others < own.zzzz;
      less_than_fourth -= others < own.wwww;
    }
    const std::array<LaneNumbers, 4> of_lanes{less, less_than_second, less_than_third, less_than_fourth};
    for (std::uint32_t lane = 0; lane < 4 && first + lane < places.size(); ++lane) {
      const LaneNumbers& counts = of_lanes[lane];
      const auto rank = static_cast<std::size_t>(counts[0] + counts[1] + counts[2] + counts[3]);
      places[rank + equal[rank]++] = first + lane;
    }
  }
  for (std::size_t begin = 0; begin < places.size();) {
    const std::size_t count = equal[begin];
    if (count == 0) {
      return false;
    }
    for (std::size_t i = begin + 1; i < begin + count; ++i) {
      for (std::size_t j = i; j > begin && is_before(places[j], places[j - 1]); --j) {
        std::swap(places[j], places[j - 1]);
      }
    }
    begin += count;
  }
  return true;
}

// Keeps its memory from use to use.
class PlacesInOrder {
 public:
  void fill(std::size_t count) {
    places_.resize(count);
    std::iota(places_.begin(), places_.end(), 0u);
  }
  // Keeps the first ones.
  void keep(std::size_t count) { places_.resize(count); }
  [[nodiscard]] std::span<std::uint32_t> all() [[clang::lifetimebound]] { return places_; }

  [[nodiscard]] std::size_t bytes() const {
    return places_.capacity() * sizeof(std::uint32_t) + (items_.capacity() + spare_.capacity()) * sizeof(Item);
  }

  // By keys; where these agree, in any order.
  template <class KeyOf>
  void sort(const KeyOf& key_of) {
    items_.clear();
    std::uint64_t any = 0, common = ~std::uint64_t{0};
    for (const std::uint32_t place : places_) {
      const std::uint64_t key = key_of(place);
      items_.push_back({key, place});
      any |= key;
      common &= key;
    }
    if (items_.size() < least_to_count) {
      std::ranges::sort(items_, {}, &Item::key);
    } else {
      count_digits(any ^ common);
    }
    for (std::size_t i = 0; i < places_.size(); ++i) {
      places_[i] = items_[i].place;
    }
  }
  // By keys; where these agree, by a comparison.
  template <class KeyOf, class IsBefore>
  void sort(const KeyOf& key_of, const IsBefore& is_before) {
    sort(key_of);
    for (std::size_t begin = 0; begin < items_.size();) {
      std::size_t end = begin + 1;
      while (end < items_.size() && items_[end].key == items_[begin].key) {
        ++end;
      }
      if (end - begin > 1) {
        std::ranges::sort(all().subspan(begin, end - begin), is_before);
      }
      begin = end;
    }
  }

 private:
  struct Item {
    std::uint64_t key;
    std::uint32_t place;
  };
  // Fewer are faster to compare than to count.
  static constexpr std::size_t least_to_count = 1024;
  static constexpr unsigned digit_bits = 11;

  // By the digits in which keys differ, the last one first. A pass keeps the order of equal digits.
  void count_digits(std::uint64_t different) {
    constexpr std::size_t digits = std::size_t{1} << digit_bits;
    spare_.resize(items_.size());
    for (unsigned shift = 0; shift < 64; shift += digit_bits) {
      const auto digit = [&](const Item& item) { return (item.key >> shift) & (digits - 1); };
      if (((different >> shift) & (digits - 1)) == 0) {
        continue;
      }
      std::array<std::uint32_t, digits> starts{};
      for (const Item& item : items_) {
        ++starts[digit(item)];
      }
      std::uint32_t sum = 0;
      for (std::uint32_t& start : starts) {
        sum += std::exchange(start, sum);
      }
      for (const Item& item : items_) {
        spare_[starts[digit(item)]++] = item;
      }
      items_.swap(spare_);
    }
  }

  std::vector<std::uint32_t> places_;
  std::vector<Item> items_, spare_;
};

}  // namespace abut
