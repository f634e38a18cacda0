// SPDX-License-Identifier: Apache-2.0
// Values by ids, each at the first free place of a table from where the bits of its id lead.
export module abut.narrow.manifold.id_table;
import abut.core.small_vector;
import abut.core.standard;

export namespace abut {

template <class Value>
class IdTable {
 public:
  // Less than half of the places are taken.
  inline explicit IdTable(std::size_t most_ids) {
    if (most_ids == 0) {
      return;
    }
    const auto bits = static_cast<int>(std::bit_width(2 * most_ids));
    shift_ = 64 - bits;
    for (std::size_t i = 0; i < std::size_t{1} << bits; ++i) {
      places_.push_back({0, {}, false});
    }
  }
  // The value of an id; one that has none takes the given value.
  inline Value& find_or_add(std::uint64_t id, const Value& value) [[clang::lifetimebound]] {
    Place& place = places_[place_of(id)];
    place = place.is_taken ? place : Place{id, value, true};
    return place.value;
  }
  [[nodiscard]] inline bool has(std::uint64_t id) const { return !places_.empty() && places_[place_of(id)].is_taken; }

 private:
  struct Place {
    std::uint64_t id;
    Value value;
    bool is_taken;
  };
  // Where an id is, or may be put.
  [[nodiscard]] inline std::size_t place_of(std::uint64_t id) const {
    std::size_t place = (id * 0x9e3779b97f4a7c15) >> shift_;
    while (places_[place].is_taken && places_[place].id != id) {
      place = (place + 1) % places_.size();
    }
    return place;
  }

  SmallVector<Place, 256> places_;
  int shift_ = 0;
};

}  // namespace abut
